# SPDX-License-Identifier: MIT
"""Ten pictures of a head with labels, and where its camera stood."""

import numpy as np

import dermis

scene = dermis.Scene.load("built-in")
session = dermis.Session(outputs=("display", "depth", "normal", "region"))
random = np.random.default_rng(1)

for number in range(10):
    view = {
        "size": (256, 256),
        "exposure": 0.0,
        "orbit": random.uniform((-60, -20), (60, 20)),
        "light": [random.uniform((-90, -10, 1), (90, 60, 4)) for _ in range(2)],
    }
    frame = session.draw(scene, **view)
    camera = scene.camera(**view)
    np.savez_compressed(
        f"sample-{number}.npz",
        display=frame.display,
        depth=frame.depth,  # metres, infinity: nothing
        normal=frame.normal @ camera.R.T,  # in the camera: +x right, +y down, +z ahead
        region=frame.region,  # 0 no skin, 1 nose, 2 ear, 3 other skin
        K=camera.K,
        R=camera.R,
        t=camera.t,
    )
