#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""readme_figures.py [--check]   Makes the figures of README.md from the records of docs/results: the text
between "<!-- figures -->" and "<!-- end of figures -->". --check changes nothing and fails, with the
difference, where README.md says something else. A record that is missing, or lacks a figure, is an error."""
import difflib
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = ROOT / "docs" / "results"
BEGIN, END = "<!-- figures -->\n", "<!-- end of figures -->\n"

# What the techniques are, in the order of the table.
TECHNIQUES = {
    "texture-space": "light blurred in the head's texture",
    "lambert": "no scattering: the floor of a frame",
    "screen-gaussians": "peer: Gaussians between pixels",
    "separable": "peer: two passes between pixels",
    "burley-disc": "peer: a disc of taps per pixel",
    "pre-integrated": "peer: tables of angle and curvature",
}


def record(name):
    return json.loads((RESULTS / name).read_text(encoding="utf-8"))


def skin_error(technique, region="skin"):
    """relMSE less the noise of the reference."""
    return technique["error"][region]["rel_mse_unbiased"]


def span(values, digits):
    return f"{min(values):.{digits}f} to {max(values):.{digits}f}"


def techniques():
    error, gpu = record("techniques-scan-side-software.json"), record("nvidia-h100.json")
    by_name = {t["name"]: t for t in error["techniques"]}
    near = next(c for c in gpu["techniques"]["cells"] if c["heads"] == 1 and c["distance"] == 2.5)
    lines = [
        "| technique | error over skin, 1e-4 | over the terminator | frame, software, ms | frame, H100, ms |",
        "|---|---|---|---|---|",
    ]
    for name, what in TECHNIQUES.items():
        t = by_name[name]
        # The column of the benchmark that is drawn as the picture was.
        column = "texture-space-compute_ms" if name == "texture-space" else name + "_ms"
        lines.append(
            f"| `{name}`: {what} | {1e4 * skin_error(t):.2f} | {1e4 * skin_error(t, 'terminator'):.2f} "
            f"| {t['frame_ms']['median']:.0f} | {near[column]:.2f} |"
        )
    nearest = sorted(TECHNIQUES, key=lambda name: skin_error(by_name[name]))
    return lines + [
        "",
        "Error: relMSE of linear light against `dermis reference`, less its noise; software: "
        f"{error['device']}, 2 cores; the scan under one hard light from the side, 240 x 270 pixels "
        "([record](docs/results/techniques-scan-side-software.json)). H100, 0.2.0: the scan near, "
        "960 x 600 pixels, maps of 1024 texels, nothing kept ([record](docs/results/nvidia-h100.json)).",
        "",
        f"**What is against us first.** In this picture the nearest is `{nearest[0]}`, then `{nearest[1]}` "
        f"and `{nearest[2]}`; light from outside the picture or from behind an occluder is "
        "[in none of the peers](docs/peers.md).",
    ]


def speed_ups():
    software = record("paper-table-360x225-software.json")["cells"]
    gpu = record("nvidia-h100.json")
    cells = gpu["paper"]["cells"]
    kept = {f["name"]: f["frame_ms"]["median"] for f in gpu["frames_kept_shadows"]}
    with_ms, without_ms = kept["near-1-sample"], kept["near-1-sample-lambert"]
    return [
        f"On an H100 one near head of 0.2.0 takes {with_ms:.2f} ms where the frame without scattering takes "
        f"{without_ms:.2f} (one sample per pixel, shadow maps kept): scattering is "
        f"{100 * (1 - without_ms / with_ms):.0f} % of the frame.",
        "",
        "The paper's three optimisations make its frames "
        f"{span([c['speedup'] for c in software], 2)} times faster in {len(software)} cells of its table on "
        f"the software driver (the paper has {span([c['paper_speedup'] for c in software], 2)}), "
        f"{span([c['speedup'] for c in cells], 2)} times in the {len(cells)} cells measured on an H100. With "
        f"all that came after, {span([c['speedup_compute'] for c in software], 1)} and "
        f"{span([c['speedup_compute'] for c in cells], 1)} times "
        "([how it is measured](docs/measuring.md#all-30-cells-as-printed)).",
    ]


def main():
    path = ROOT / "README.md"
    text = path.read_text(encoding="utf-8")
    head, rest = text.split(BEGIN)
    _, tail = rest.split(END)
    block = "\n".join(techniques() + speed_ups()) + "\n"
    made = head + BEGIN + block + END + tail
    if sys.argv[1:] == ["--check"]:
        sys.stdout.writelines(
            difflib.unified_diff(text.splitlines(True), made.splitlines(True), "README.md", "the records")
        )
        sys.exit(text != made)
    path.write_text(made, encoding="utf-8")


main()
