#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the tables of docs/truth.md from the results of bench/truth/truth.sh.

usage: tools/truth_table.py OUT [--cost]      (without --cost the times, which need a quiet machine, are left out)
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


def main():
    folder, cost = pathlib.Path(sys.argv[1]), "--cost" in sys.argv
    for path in sorted(folder.glob("*.result.json")):
        result = json.loads(path.read_text())
        reference = result["reference"]
        print(f"**{path.name.removesuffix('.result.json')}**: {result['scene']}, {result['size'][0]} x {result['size'][1]}, "
              f"{reference.get('model', reference.get('file'))}, {reference.get('samples', '-')} samples a pixel, "
              f"noise {reference.get('noise_percent', 0):.2f} %\n")
        rows = []
        for technique in result["techniques"] + [{"name": "noise of the reference", "error": result["noise"]}]:
            if not technique["error"]:
                continue
            skin = technique["error"]["skin"]
            row = [technique["name"]]
            if cost:
                row.append(f"{technique['frame_ms']['median']:.1f}" if "frame_ms" in technique else "-")
            rows.append(row + [f"{skin['flip']:.4f}", f"{skin['hdr_flip']:.4f}", f"{skin['psnr_db']:.2f}", number(skin["rel_mse"]),
                               number(skin["rel_mse_unbiased"])])
        table(["technique"] + (["frame ms"] if cost else []) + ["FLIP", "HDR-FLIP", "PSNR dB", "relMSE", "less noise"], rows)
        plain = [t for t in result["techniques"] if "--optimise" not in t["name"]]
        rows = []
        for region in result["regions"]:
            if region["pixels"] == 0:
                rows.append([region["name"], "empty"] + ["-"] * (2 * len(plain)))
                continue
            errors = [t["error"][region["name"]] for t in plain]
            rows.append([region["name"], str(region["pixels"])] + [f"{e['hdr_flip']:.4f}" for e in errors]
                        + [number(e["rel_mse_unbiased"] if e["rel_mse_unbiased"] is not None else e["rel_mse"]) for e in errors])
        table(["region", "pixels"] + [f"HDR-FLIP {t['name']}" for t in plain] + [f"relMSE {t['name']}" for t in plain], rows)


if __name__ == "__main__":
    main()
