#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fits the law of totals over curvature (src/tissue/profile/shape_laws.cpp) to what shapes_bench writes.

usage: tools/shape_laws.py RESULT.json...
       tools/shape_laws.py --run build/release/bench/shapes/shapes_bench OUT [WALKS]

With --run, follows light through the bodies of the fit first: media of a mean free path of 1 mm, three
albedos at a time, indices of 1.3, 1.4 and 1.5. Prints the constants in the order of the code, and the error
by shape and radius. Standard library alone.
"""
import json
import math
import pathlib
import subprocess
import sys

ALBEDOS = [(0.2, 0.6, 0.8), (0.88, 0.94, 0.97), (0.985, 0.9925, 0.997)]
RADII = (4, 6, 8, 12, 16, 24, 48)
# src/tissue/profile/shape_laws.cpp: a, b convex, b concave, d and c of docs/theory.md.
IN_THE_CODE = [3.085, -4.032, 2.122, 1.221, -1.672, 0.5284, -1.843, -0.564, 0.9235, 1.387, 0.3257, -0.4894,
               1.822, -1.047]
SIGN = {"sphere": 1, "cylinder": 1, "bowl": -1, "groove": -1}


def run(program, folder, walks):
    folder.mkdir(parents=True, exist_ok=True)
    bodies = [f"{shape}:{radius}" for shape in SIGN for radius in RADII]
    for eta in (1.3, 1.4, 1.5):
        for number, albedos in enumerate(ALBEDOS):
            out = folder / f"{eta}-{number}.json"
            medium = (f"sigma_a={','.join(f'{1 - a:.6g}' for a in albedos)} "
                      f"sigma_s={','.join(f'{a:.6g}' for a in albedos)} g=0 eta={eta}")
            if not out.exists():
                subprocess.run([program, out, str(walks), medium, *bodies], check=True)
    return sorted(folder.glob("*.json"))


def totals(path):
    """(index, albedo, H, D, the total that fits best, shape, radius) of each body and channel."""
    result = json.loads(path.read_text())
    values = dict(word.split("=") for word in result["medium"].split())
    albedos = [float(s) for s in values["sigma_s"].split(",")]
    for body in result["bodies"]:
        shape, radius = body["body"].split(":")[0], float(body["body"].split(":")[1])
        if shape not in SIGN:
            continue
        round_body = shape in ("sphere", "bowl")
        mean, half = SIGN[shape] / radius * (1 if round_body else 0.5), 0 if round_body else 0.5 / radius
        for channel, albedo in enumerate(albedos):
            both = blur2 = 0
            for light in body["lights"]:
                share = math.sin(math.radians(light["light_deg"])) if round_body else 1
                both += share * light["exitance"][channel] * light["blurred"][channel]
                blur2 += share * light["blurred"][channel] ** 2
            yield float(values["eta"]), albedo, mean, half, both / blur2, shape, radius


def law(p, row):
    eta, albedo, mean, half = row[:4]
    x, e = math.sqrt(1 - albedo), eta - 1.4
    a = (p[0] + p[1] * x + p[2] * x * x) * (1 + (p[3] + p[4] * x) * e)
    b = (p[5] / x + p[6]) * (1 + p[7] * e) if mean > 0 else p[8] / math.sqrt(x) + p[9]
    below = 1 + b * abs(mean) + (p[10] / x + p[11]) * half
    return 1 + a * mean / below + (p[12] + p[13] * x) * half * half


def solve(matrix, right):
    """Gauss with pivots."""
    size = len(right)
    rows = [list(matrix[i]) + [right[i]] for i in range(size)]
    for i in range(size):
        best = max(range(i, size), key=lambda r: abs(rows[r][i]))
        rows[i], rows[best] = rows[best], rows[i]
        for r in range(i + 1, size):
            factor = rows[r][i] / rows[i][i]
            for c in range(i, size + 1):
                rows[r][c] -= factor * rows[i][c]
    out = [0.0] * size
    for i in reversed(range(size)):
        out[i] = (rows[i][size] - sum(rows[i][c] * out[c] for c in range(i + 1, size))) / rows[i][i]
    return out


def fit(rows):
    """Levenberg-Marquardt; errors of weak curvature weigh more, because most of a head is flat."""
    p = list(IN_THE_CODE)

    def residuals(q):
        return [(law(q, row) - row[4]) / (abs(row[2]) + 0.05) for row in rows]

    now, damping = residuals(p), 1e-3
    for _ in range(60):
        slopes = []
        for k in range(len(p)):
            step = 1e-6 * max(abs(p[k]), 1)
            moved = residuals(p[:k] + [p[k] + step] + p[k + 1:])
            slopes.append([(m - n) / step for m, n in zip(moved, now)])
        normal = [[sum(a * b for a, b in zip(s, t)) for t in slopes] for s in slopes]
        gradient = [-sum(a * b for a, b in zip(s, now)) for s in slopes]
        for k in range(len(p)):
            normal[k][k] *= 1 + damping
        there = [a + b for a, b in zip(p, solve(normal, gradient))]
        then = residuals(there)
        if sum(r * r for r in then) < sum(r * r for r in now):
            p, now, damping = there, then, damping * 0.3
        else:
            damping *= 5
    return p


def report(rows, p):
    print("constants:", ", ".join(f"{value:.4g}" for value in p))
    for shape in SIGN:
        for low, high in ((4, 5), (6, 9), (10, 100)):
            errors = [law(p, row) - row[4] for row in rows if row[5] == shape and low <= row[6] < high]
            if errors:
                rms = math.sqrt(sum(e * e for e in errors) / len(errors))
                print(f"{shape:<9} radius {low} to {high}: {len(errors)} totals, "
                      f"root of the mean square {rms:.4f}, largest {max(map(abs, errors)):.4f}")


def main():
    arguments = sys.argv[1:]
    if not arguments:
        sys.exit(__doc__)
    if arguments[0] == "--run":
        walks = int(arguments[3]) if len(arguments) > 3 else 200_000
        paths = run(arguments[1], pathlib.Path(arguments[2]), walks)
    else:
        paths = [pathlib.Path(name) for name in arguments]
    rows = [row for path in paths for row in totals(path)]
    if not rows:
        sys.exit("no spheres, cylinders, bowls or grooves in these results")
    print("as in src/tissue/profile/shape_laws.cpp:")
    report(rows, IN_THE_CODE)
    print("fitted to these:")
    report(rows, fit(rows))


if __name__ == "__main__":
    main()
