# SPDX-License-Identifier: MIT
"""Three techniques against ground truth, by region."""

import dermis
import dermis.compare
import dermis.reference

scene = dermis.Scene.load("built-in")
truth = dermis.reference.render(scene, reference={"samples": 64}, size=(96, 96), light=[(60, 10)])
table = dermis.compare.techniques(
    scene, ["texture-space", "separable", "lambert"], truth=truth, size=(96, 96), light=[(60, 10)]
)
for row in table.rows:
    print(f"{row.technique:14} {row.region:12} {row.relative_mse_less_noise:.2e} {row.frame_ms:.0f} ms")
