#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the tables of docs/truth.md from the results of bench/truth/truth.sh.

usage: tools/truth_table.py OUT [--cost]
       (without --cost the times, which need a quiet machine, are left out)
"""
import json
import pathlib
import sys


def number(value):
    if value is None:
        return "-"
    return f"{value:.2e}".replace("e-0", "e-") if abs(value) < 0.1 else f"{value:.3f}"


def table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def unbiased_if_known(error):
    unbiased = error["rel_mse_unbiased"]
    return error["rel_mse"] if unbiased is None else unbiased


def main():
    folder, cost = pathlib.Path(sys.argv[1]), "--cost" in sys.argv
    for path in sorted(folder.glob("*.result.json")):
        result = json.loads(path.read_text())
        reference = result["reference"]
        width, height = result["size"]
        print(f"**{path.name.removesuffix('.result.json')}**: {result['scene']}, {width} x {height}, "
              f"{reference.get('model', reference.get('file'))}, "
              f"{reference.get('samples', '-')} samples per pixel, "
              f"noise {reference.get('noise_percent', 0):.2f} %\n")
        rows = []
        noise = {"name": "noise of the reference", "error": result["noise"]}
        for technique in result["techniques"] + [noise]:
            if not technique["error"]:
                continue
            skin = technique["error"]["skin"]
            row = [technique["name"]]
            if cost:
                row.append(f"{technique['frame_ms']['median']:.1f}" if "frame_ms" in technique else "-")
            row += [f"{skin['flip']:.4f}", f"{skin['hdr_flip']:.4f}", f"{skin['psnr_db']:.2f}"]
            rows.append(row + [number(skin["rel_mse"]), number(skin["rel_mse_unbiased"])])
        columns = ["technique"] + (["frame ms"] if cost else [])
        table(columns + ["FLIP", "HDR-FLIP", "PSNR dB", "relMSE", "less noise"], rows)

        plain = [t for t in result["techniques"]
                 if "--optimise" not in t["name"] and "--blur" not in t["name"]]
        rows = []
        for region in result["regions"]:
            if region["pixels"] == 0:
                rows.append([region["name"], "empty"] + ["-"] * (2 * len(plain)))
                continue
            errors = [t["error"][region["name"]] for t in plain]
            row = [region["name"], str(region["pixels"])] + [f"{e['hdr_flip']:.4f}" for e in errors]
            rows.append(row + [number(unbiased_if_known(e)) for e in errors])
        columns = ["region", "pixels"] + [f"HDR-FLIP {t['name']}" for t in plain]
        table(columns + [f"relMSE {t['name']}" for t in plain], rows)


if __name__ == "__main__":
    main()
