#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes src/render/shared/quarter_turn.inc: real spherical harmonics up to order 5, turned by 90 degrees
about +X (+Y becomes +Z). Needs nothing but Python.

The harmonics are those of src/environment/harmonics.h. Each weight is an overlap of a turned harmonic with
one that is not, by quadrature; its square is a fraction over a power of 2, which makes it exact.
"""
from math import cos, factorial, pi, sin, sqrt
from pathlib import Path

ORDER = 5
HEIGHTS = [(0.2386191860831969, 0.4679139345726910), (0.6612093864662645, 0.3607615730481386),
           (0.9324695142031521, 0.1713244923791704)]  # Gauss and Legendre, six points: exact up to degree 11


def harmonics(x, y, z):
    out = [0.0] * (ORDER + 1) ** 2
    cosine, sine, diagonal = 1.0, 0.0, 1.0
    for m in range(ORDER + 1):
        before, here = 0.0, diagonal
        for l in range(m, ORDER + 1):
            norm = sqrt((2 if m else 1) * (2 * l + 1) / (4 * pi) * factorial(l - m) / factorial(l + m))
            out[l * (l + 1) + m] = norm * here * cosine
            if m:
                out[l * (l + 1) - m] = norm * here * sine
            before, here = here, (y * (2 * l + 1) * here - (l + m) * before) / (l - m + 1)
        diagonal *= 2 * m + 1
        cosine, sine = cosine * z - sine * x, cosine * x + sine * z
    return out


def weights():
    n = (ORDER + 1) ** 2
    sums = [[0.0] * n for _ in range(n)]
    for height, share in [(s * h, w) for h, w in HEIGHTS for s in (1, -1)]:
        for k in range(12):
            across, azimuth = sqrt(1 - height * height), 2 * pi * k / 12
            x, y, z = across * sin(azimuth), height, across * cos(azimuth)
            # The turned function has at (x, y, z) what the function has at the direction turned back.
            there, back = harmonics(x, y, z), harmonics(x, z, -y)
            for i in range(n):
                for j in range(n):
                    sums[i][j] += there[i] * back[j] * share * 2 * pi / 12
    return sums


def exact(value):
    square = round(value * value * 4 ** ORDER)
    assert abs(square / 4 ** ORDER - value * value) < 1e-12, value
    return (1 if value > 0 else -1) * sqrt(square / 4 ** ORDER)


def main():
    sums = weights()
    lines = ["// SPDX-License-Identifier: MIT",
             "// Written by tools/quarter_turn.py. QUARTER_TURN(to, from, weight), by order.",
             "#ifdef QUARTER_TURN"]
    for l in range(1, ORDER + 1):
        numbers = range(l * l, (l + 1) ** 2)
        for i in numbers:
            for j in numbers:
                if abs(sums[i][j]) > 1e-9:
                    lines.append(f"QUARTER_TURN({i}, {j}, {exact(sums[i][j]):.17g})")
    lines.append("#endif")
    path = Path(__file__).resolve().parent.parent / "src/render/shared/quarter_turn.inc"
    path.write_text("\n".join(lines) + "\n")


main()
