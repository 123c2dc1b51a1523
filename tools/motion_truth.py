#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures heads in a clip against ground truth, by region: docs/accuracy.md, "Heads that move".

usage: tools/motion_truth.py OUT HEAD.glb... [options]

One hard light, the file at rest and evenly spread frames of its first clip. The reference of each is rendered
once and kept in OUT, so that a second program is measured with the same. Prints the error of `texture-space`
less noise, and how many times that of the rest pose it is; in brackets what the noise of the reference leaves
open, one standard error. With a --camera by --eye and --target, each frame is also drawn of the head *loaded*
in its pose, where all that is found of a shape is of that pose, against a reference of its own: error over
error is what motion costs, and the rest is what there is to see in that view.
"""
import argparse
import json
import math
import pathlib
import subprocess


def run(command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def pose(frame, a):
    return [] if frame is None else ["--time", f"{frame * a.end / a.frames:.6g}"]


def loaded_in_pose(head, frame, a):
    """Writes a scene file whose asset is loaded in the pose of a frame."""
    file = pathlib.Path(a.out) / f"{pathlib.Path(head).stem}-{frame}.scene.json"
    asset = {"name": "head", "file": str(pathlib.Path(head).resolve()), "clip": "",
             "time_s": frame * a.end / a.frames}
    file.write_text(json.dumps({"dermis_scene": 1, "assets": [asset], "instances": [{"asset": "head"}]}))
    return file


def measure(head, frame, a, loaded=False):
    """Errors by region of one picture: HDR-FLIP, relMSE less noise, relMSE of the noise, pixels."""
    out = pathlib.Path(a.out)
    name = f"{pathlib.Path(head).stem}-{'rest' if frame is None else frame}{'-loaded' if loaded else ''}"
    truth, variance, result = (out / f"{name}{end}" for end in (".exr", ".variance.exr", f"{a.tag}.json"))
    scene = [loaded_in_pose(head, frame, a)] if loaded else [head, *pose(frame, a)]
    view = ["--light", a.light, "--size", a.size, *a.camera.split()]
    if not truth.exists():
        run([a.dermis, "reference", *scene, *view, "--samples", a.samples, "--variance", variance,
             "-o", truth])
    if not result.exists():
        run([a.dermis, "compare", "--scene", *scene, *view, "--reference", truth, "--variance", variance,
             "--techniques", "texture-space", "--map-size", a.map_size, "--shadow-size", a.shadow_size,
             "--json", result])
    found = json.loads(result.read_text())
    pixels = {region["name"]: region["pixels"] for region in found["regions"]}
    errors = {}
    for region, e in found["techniques"][0]["error"].items():
        if e:
            errors[region] = (e["hdr_flip"], e["rel_mse_unbiased"], e["rel_mse"] - e["rel_mse_unbiased"],
                              pixels[region])
    return errors


def uncertainty(error):
    """Of relMSE less noise: d^2 + 2 d n + n^2 - s^2 has the variance 4 d^2 s^2 + 2 s^4, pixel by pixel."""
    _, unbiased, noise, pixels = error
    return math.sqrt((4 * max(unbiased, 0) * noise + 2 * noise**2) / pixels)


def over(error, other):
    """The ratio of two relMSE, and what noise leaves open of it."""
    ratio = error[1] / other[1]
    open_ = ratio * math.hypot(uncertainty(error) / max(error[1], 1e-12), uncertainty(other) / other[1])
    return f"{ratio:.2f} ({open_:.2f})"


def row(region, rest, frames, loaded):
    cells = [region, str(rest[3]), f"{rest[0]:.4f}", f"{rest[1]:.2e} ({uncertainty(rest):.0e})"]
    for e, same in zip(frames, loaded):
        if not e:
            cells.append("empty")
            continue
        cells.append(f"{e[0] / rest[0]:.2f}, {over(e, rest)}, {e[3]} px")
        if same:
            cells[-1] += f"; {e[0] / same[0]:.2f}, {over(e, same)}"
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(usage=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("out")
    parser.add_argument("heads", nargs="+")
    parser.add_argument("--dermis", default="build/release/dermis")
    parser.add_argument("--frames", type=int, default=48)
    parser.add_argument("--shown", default="0,12,24,36")
    parser.add_argument("--end", type=float, default=6, help="of the clip, s")
    parser.add_argument("--light", default="60,20")
    parser.add_argument("--camera", default="", help="options of the camera")
    parser.add_argument("--size", default="192x216")
    parser.add_argument("--samples", type=int, default=512)
    parser.add_argument("--map-size", type=int, default=1024)
    parser.add_argument("--shadow-size", type=int, default=4096)
    parser.add_argument("--tag", default="", help="of the program or its settings, in names of results")
    a = parser.parse_args()
    pathlib.Path(a.out).mkdir(parents=True, exist_ok=True)
    shown = [int(n) for n in a.shown.split(",")]

    for head in a.heads:
        rest = measure(head, None, a)
        frames = [measure(head, frame, a) for frame in shown]
        controls = [measure(head, f, a, loaded=True) if "--eye" in a.camera else {} for f in shown]
        print(f"**{pathlib.Path(head).name}**: HDR-FLIP and relMSE less noise, over those of the rest pose"
              "; over those of the head loaded in the pose\n")
        print("| region | pixels | HDR-FLIP at rest | relMSE at rest | "
              + " | ".join(f"frame {frame}" for frame in shown) + " |")
        print("|---" * (4 + len(shown)) + "|")
        for region in rest:
            print(row(region, rest[region], [f.get(region) for f in frames],
                      [c.get(region) for c in controls]))
        print()


if __name__ == "__main__":
    main()
