#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""truth_record.py OUT COMMIT [NAME]   Writes the record of bench/truth/truth.sh OUT to docs/results (NAME:
truth-cases-software.json). docs/accuracy.md shows it (tools/document_figures.py). Without times, which need a
quiet machine."""
import json
import pathlib
import sys

MEASURES = ("flip", "hdr_flip", "psnr_db", "rel_mse", "rel_mse_unbiased")


def rounded(value):
    return None if value is None else float(f"{value:.4g}")


def case_of(path):
    result = json.loads(path.read_text())
    reference = result["reference"]
    techniques = []
    for technique in result["techniques"]:
        if not technique["error"]:
            continue
        error = {
            region: [rounded(e[m]) for m in MEASURES] for region, e in technique["error"].items() if e
        }
        at_size = technique.get("at_size") or {}
        techniques.append(
            {"name": technique["name"], "at_size_rel_mse": rounded(at_size.get("rel_mse")), "error": error}
        )
    return {
        "case": path.name.removesuffix(".result.json"),
        "scene": result["scene"],
        "size": result["size"],
        "model": reference["model"],
        "samples": reference["samples"],
        "noise_percent": rounded(reference["noise_percent"]),
        "pixels": {r["name"]: r["pixels"] for r in result["regions"]},
        "device": result["device"],
        "techniques": techniques,
    }


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    name = sys.argv[3] if len(sys.argv) > 3 else "truth-cases-software.json"
    record = {
        "what": "error of every technique in every case, over skin and by region",
        "command": "bench/truth/truth.sh OUT",
        "commit": sys.argv[2],
        "measures": MEASURES,
        "cases": [case_of(p) for p in sorted(folder.glob("*.result.json"))],
    }
    root = pathlib.Path(__file__).resolve().parent.parent
    (root / "docs" / "results" / name).write_text(json.dumps(record, separators=(",", ":")) + "\n")


if __name__ == "__main__":
    main()
