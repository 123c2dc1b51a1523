#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""document_figures.py [--check]   Makes the tables of figures of README.md and docs/*.md from the records of
docs/results: the text between "<!-- figures: NAME -->" and "<!-- end of figures -->". --check changes nothing
and fails, with the difference, where a document says something else. A record that is missing, or lacks a
figure, is an error, and so is a table that no document shows."""
import difflib
import json
import math
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = ROOT / "docs" / "results"
BLOCK = re.compile(r"(<!-- figures: ([a-z0-9 ]+) -->\n)(.*?)(<!-- end of figures -->\n)", re.DOTALL)

# What the techniques are, in the order of the tables.
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


def table(columns, rows):
    lines = ["| " + " | ".join(str(c) for c in columns) + " |", "|" + "---|" * len(columns)]
    return lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]


def names():
    return [f"`{name}`" for name in TECHNIQUES]


def skin_error(technique):
    """relMSE less the noise of the reference."""
    return technique["error"]["skin"]["rel_mse_unbiased"]


def at_size(technique):
    return technique["at_size"]["rel_mse_unbiased"]


def span(values, digits):
    return f"{min(values):.{digits}f} to {max(values):.{digits}f}"


def link(name, of_readme=False):
    return f"[record]({'docs/' if of_readme else ''}results/{name})"


def scaled(value):
    """In units of 1e-4."""
    return "-" if value is None else f"{1e4 * value:.2f}" if value < 1e-2 else f"{1e4 * value:.0f}"


# README.md


def readme():
    return techniques() + speed_ups()


def techniques():
    side, gpu = "techniques-scan-side-software.json", "nvidia-h100.json"
    error = record(side)
    by_name = {t["name"]: t for t in error["techniques"]}
    near = near_cell(record(gpu))
    rows = [
        [
            f"`{name}`: {what}",
            f"{1e4 * skin_error(by_name[name]):.2f}",
            f"{1e4 * at_size(by_name[name]):.2f}",
            f"{by_name[name]['frame_ms']['median']:.0f}",
            f"{near[column_of(name)]:.2f}",
        ]
        for name, what in TECHNIQUES.items()
    ]
    columns = ["technique", "error over skin, 1e-4", "at size", "frame, software, ms"]
    nearest, shown_nearest = (
        sorted(TECHNIQUES, key=lambda name: error_of(by_name[name])) for error_of in (skin_error, at_size)
    )
    return table(columns + ["frame, H100, ms"], rows) + [
        "",
        "Error: relMSE of linear light against `dermis reference`, less its noise: of a super-sampled "
        "picture, and at its size. Software: "
        f"{error['device']}, 2 cores; the scan under one hard light from the side, 240 x 270 pixels "
        f"({link(side, True)}). H100, 0.2.0: the scan near, 960 x 600 pixels, maps of 1024 texels, "
        f"nothing kept ({link(gpu, True)}).",
        "",
        f"**What is against us first.** Super-sampled, the nearest is `{nearest[0]}`, then `{nearest[1]}`. "
        f"At size it is `{shown_nearest[0]}`, then `{shown_nearest[1]}`. Light from outside the picture or "
        "from behind an occluder is [in none of the peers](docs/choosing.md#where-each-has-trouble).",
    ]


def near_cell(gpu):
    return next(c for c in gpu["techniques"]["cells"] if c["heads"] == 1 and c["distance"] == 2.5)


def column_of(name):
    """The column of the benchmark that is drawn as the picture was."""
    return "texture-space-compute_ms" if name == "texture-space" else name + "_ms"


def speed_ups():
    software = record("paper-table-360x225-software.json")["cells"]
    gpu = record("nvidia-h100.json")
    cells = gpu["paper"]["cells"]
    kept = {f["name"]: f["frame_ms"]["median"] for f in gpu["frames_kept_shadows"]}
    with_ms, without_ms = kept["near-1-sample"], kept["near-1-sample-lambert"]
    return [
        f"On an H100 one near head of 0.2.0 takes {with_ms:.2f} ms where the frame without scattering takes "
        f"{without_ms:.2f} (one sample per pixel, shadow maps kept). Scattering is "
        f"{100 * (1 - without_ms / with_ms):.0f} % of the frame.",
        "",
        "The paper's three optimisations make its frames "
        f"{span([c['speedup'] for c in software], 2)} times faster in {len(software)} cells of its table on "
        f"the software driver. The paper has {span([c['paper_speedup'] for c in software], 2)}; "
        f"{len(cells)} cells on an H100 have {span([c['speedup'] for c in cells], 2)}. `texture-space` is "
        f"{span([c['speedup_compute'] for c in software], 1)} times faster than `published` without them, "
        f"{span([c['speedup_compute'] for c in cells], 1)} on the H100 "
        "([table](docs/performance.md#the-papers-table)).",
    ]


# docs/performance.md


def h100():
    gpu = record("nvidia-h100.json")
    rows = [
        [c["heads"], f"{c['distance']:g}"]
        + [f"{c[k]:.2f}" for k in ("baseline_ms", "all_ms", "compute_ms", "still_ms", "lambert_compute_ms")]
        for c in gpu["paper"]["cells"]
    ]
    columns = ["heads", "radii", "published, unoptimised", "published, optimised", "`texture-space`"]
    return table(columns + ["shadow maps kept", "no scattering"], rows) + ["", link("nvidia-h100.json")]


def paper_table():
    name = "paper-table-360x225-software.json"
    cells = record(name)["cells"]
    heads, distances = (sorted({c[k] for c in cells}) for k in ("heads", "distance"))
    by_place = {(c["heads"], c["distance"]): c for c in cells}
    rows = []
    for h in heads:
        of_row = [by_place[h, d] for d in distances]
        rows.append([h] + [f"{c['speedup']:.2f} ({c['paper_speedup']:.2f})" for c in of_row])
    lines = table(["heads"] + [f"{d:g} radii" for d in distances], rows)
    below = sum(c["speedup_over_skip"] < c["paper_speedup"] for c in cells)
    return lines + [
        "",
        "Over a baseline without heads outside the picture: "
        f"{span([c['speedup_over_skip'] for c in cells], 2)}, below the paper's in {below} cells. "
        f"By `texture-space`: {span([c['speedup_compute'] for c in cells], 1)} ({link(name)}).",
    ]


def terms():
    found = record("terms-by-need-software.json")
    lines = table(found["texels"]["columns"], found["texels"]["rows"])
    frames = {row[0]: row[2] for row in found["frames"]["rows"]}
    return lines + ["", f"Frames: {frames['2.5 radii']} ms at 2.5 radii, {frames['10 radii']} at 10."]


def sessions():
    rows = []
    for device, name in (("software", "sessions-software.json"), ("H100", "nvidia-h100.json")):
        for s in record(name)["sessions"]:
            rows.append([device, s["instances"], f"{s['host_ms']:.2f}", f"{s['frame_ms']:.1f}"])
    return table(["device", "instances", "host, ms per frame", "whole frame, ms"], rows)


# docs/choosing.md


def peer_scenes():
    name = "peers-scenes-software.json"
    shown = [*TECHNIQUES, "published"]
    rows = [
        [case["case"].removeprefix("test:")] + [scaled(case["at_size_unbiased"][t]) for t in shown]
        for case in record(name)["cases"]
    ]
    return table(["scene"] + [f"`{t}`" for t in shown], rows) + ["", link(name)]


def peer_scan():
    name = "peers-scan-software.json"
    cases = record(name)["cases"]
    rows = []
    for technique in [*TECHNIQUES, "published"]:
        row = [f"`{technique}`"]
        for case in cases:
            taps = case["taps_per_pixel"][technique]
            row += [
                f"{scaled(case['at_size_unbiased'][technique])}; {scaled(case['unbiased'][technique])}",
                f"{taps:.0f}" if taps else "-",
                f"{case['device_bytes'][technique] / 1e6:.0f}",
            ]
        rows.append(row)
    columns = ["technique"]
    for case in cases:
        columns += [case["case"], "taps per pixel", "MB"]
    return table(columns, rows) + ["", link(name)]


def peer_grid():
    cells = record("nvidia-h100.json")["techniques"]["cells"]
    rows = [
        [c["heads"], f"{c['distance']:g}", f"{100 * c['coverage']:.1f} %"]
        + [f"{c[column_of(name)]:.2f}" for name in TECHNIQUES]
        for c in cells
    ]
    source = link("nvidia-h100.json") + ", version 0.2.0"
    return table(["heads", "radii", "skin"] + names(), rows) + ["", source]


# docs/accuracy.md

LESS_NOISE = 4  # of "measures" of the record


def truth_cases():
    name = "truth-cases-software.json"
    cases = record(name)["cases"]
    shown = list(TECHNIQUES) + ["published"]
    rows, by_case = [], []
    for case in cases:
        by_name = {t["name"]: t for t in case["techniques"]}
        by_case.append((by_name, "volume" in case["case"]))
        row = [case["case"], f"{case['noise_percent']:.1f} %"]
        for t in shown:
            row.append(f"{scaled(large(by_name[t]))}; {1e4 * by_name[t]['at_size_rel_mse']:.1f}")
        rows.append(row)

    def count(wins, of_volume):
        return sum(wins(by_name) for by_name, volume in by_case if volume == of_volume)

    def blur_wins(by_name):
        return min(large(by_name[t]) for t in ("screen-gaussians", "separable")) < large(by_name[shown[0]])

    def published_wins(by_name):
        return by_name["published"]["at_size_rel_mse"] < by_name[shown[0]]["at_size_rel_mse"]

    volumes = sum(volume for _, volume in by_case)
    flat = len(by_case) - volumes
    return table(["case", "noise"] + [f"`{t}`" for t in shown], rows) + [
        "",
        link(name),
        "",
        "**What is against us first.** Of super-sampled pictures, a blur of the picture is nearer than "
        f"`texture-space` in {count(blur_wins, False)} of {flat} cases against `bssrdf`. Against `volume` it "
        f"is in {count(blur_wins, True)} of {volumes}. At the size of the picture, `published` is nearer in "
        f"{count(published_wins, False) + count(published_wins, True)} of {len(by_case)}. Its maps of full "
        "size average light that a pixel undersamples, and take several times as long.",
    ]


def large(technique):
    """Error over skin of the super-sampled picture."""
    return technique["error"]["skin"][LESS_NOISE]


def truth_regions():
    cases = {c["case"]: c for c in record("truth-cases-software.json")["cases"]}
    case = cases["scan-0-bssrdf"]
    by_name = {t["name"]: t for t in case["techniques"]}
    rows = []
    for region, pixels in case["pixels"].items():
        if pixels:
            errors = [scaled(by_name[t]["error"][region][LESS_NOISE]) for t in TECHNIQUES]
            rows.append([region, pixels] + errors)
    return table(["region", "pixels"] + names(), rows)


def shape():
    cases = record("shape-aware-software.json")["cases"]
    shown = ("texture-space, --shape-aware off", "texture-space", "lambert")
    groups = {"all": cases}
    for light in ("side", "front", "behind"):
        groups[f"light from {'the ' if light != 'behind' else ''}{light}"] = [
            c for c in cases if c["case"].endswith("-" + light)
        ]
    for skin in ("skin1", "skin2", "light", "medium", "dark"):
        groups[skin] = [c for c in cases if c["case"].rsplit("-", 2)[1] == skin]
    rows = []
    for region in ("skin", "nose", "ears"):
        for group, of_group in groups.items():
            if region != "skin" and not group.startswith("light from"):
                continue
            errors = [[c["rel_mse_less_noise"][s].get(region) for s in shown] for c in of_group]
            errors = [e for e in errors if None not in e]
            off, on, without = (sum(e[k] for e in errors) / len(errors) for k in range(3))
            label = group if region == "skin" else f"{region}, {group}"
            nearer = f"{math.sqrt(without / off):.1f}, {math.sqrt(without / on):.1f}"
            figures = [scaled(off), scaled(on), scaled(without), f"{on / off:.2f}", nearer]
            rows.append([label, len(errors)] + figures)
    columns = ["cases", "number", "off", "on", "`lambert`", "on over off", "nearer than `lambert`: off, on"]
    return table(columns, rows) + ["", "Units of 1e-4; " + link("shape-aware-software.json")]


def suns():
    found = record("suns-software.json")
    rows = []
    for pixels in (1, 4, 16):
        cells = [c["skin"] for c in found["cells"] if c["cell"].startswith(f"sun-{pixels}-")]
        flip, psnr, error = (
            sorted(c[k] for c in cells) for k in ("flip", "psnr_db", "rel_mse_unbiased")
        )
        middle = len(cells) // 2
        rows.append(
            [
                f"sun of {pixels} pixel{'s' if pixels > 1 else ''}, {len(cells)} skies",
                f"{flip[middle]:.4f}, {flip[-1]:.4f}",
                f"{psnr[middle]:.1f}, {psnr[0]:.1f}",
                f"{scaled(error[middle])}, {scaled(error[-1])}",
            ]
        )
    studio = found["studio"]
    rows.append(
        [
            "the built-in studio",
            f"{studio['flip']:.4f}",
            f"{studio['psnr_db']:.1f}",
            scaled(studio["rel_mse_unbiased"]),
        ]
    )
    columns = ["surroundings", "FLIP: median, largest", "PSNR dB: median, least"]
    lines = table(columns + ["relMSE less noise, 1e-4: median, largest"], rows)
    return lines + ["", link("suns-software.json")]


def second_opinion():
    """Mean colour of Mitsuba's picture over ours."""
    rows = []
    for case in record("second-opinion.json")["cases"]:
        for region, found in case["regions"].items():
            if region != "skin" and (region, "head" in case["case"]) != ("terminator", True):
                continue
            ratios = [
                f"{ratio:.3f} ± {error:.3f}"
                for ratio, error in zip(found["mitsuba_over_ours"], found["standard_error"])
            ]
            label = case["case"] if region == "skin" else f"{case['case']}, {region}"
            noise = scaled(found["rel_mse"] - found["rel_mse_less_noise"])
            rows.append([label, *ratios, scaled(found["rel_mse_less_noise"]), noise])
    columns = ["body", "red", "green", "blue", "relMSE less noise, 1e-4", "noise"]
    return table(columns, rows) + ["", link("second-opinion.json")]


TABLES = {
    "readme": readme,
    "h100": h100,
    "paper table": paper_table,
    "terms": terms,
    "sessions": sessions,
    "peer scenes": peer_scenes,
    "peer scan": peer_scan,
    "peer grid": peer_grid,
    "truth cases": truth_cases,
    "truth regions": truth_regions,
    "shape": shape,
    "suns": suns,
    "second opinion": second_opinion,
}


def main():
    shown, differs = set(), False
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        text = path.read_text(encoding="utf-8")

        def made_of(found):
            shown.add(found[2])
            return found[1] + "\n".join(TABLES[found[2]]()) + "\n" + found[4]

        made = BLOCK.sub(made_of, text)
        if sys.argv[1:] == ["--check"]:
            difference = difflib.unified_diff(
                text.splitlines(True), made.splitlines(True), path.name, "the records"
            )
            sys.stdout.writelines(difference)
            differs = differs or text != made
        elif text != made:
            path.write_text(made, encoding="utf-8")
    missing = sorted(set(TABLES) - shown)
    if missing:
        print(f"no document shows: {', '.join(missing)}")
    sys.exit(differs or bool(missing))


main()
