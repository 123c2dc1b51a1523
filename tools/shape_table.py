#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the tables of skin that knows its shape from the results of bench/truth/shape.sh.

usage: tools/shape_table.py OUT [--regions]
"""
import json
import math
import pathlib
import re
import sys

NAMES = ("texture-space", "texture-space, shape_aware off", "lambert")


def errors(result, region):
    by_name = {t["name"]: t["error"].get(region) for t in result["techniques"]}
    if any(not by_name.get(name) for name in NAMES):
        return None
    return [by_name[name]["rel_mse_unbiased"] for name in NAMES]


def noise_percent(folder, case):
    """What `dermis reference` said of its picture."""
    found = re.search(r"noise ([\d.]+) %", (folder / f"{case}.reference.txt").read_text())
    return float(found.group(1))


def root_ratio(a, b):
    return math.sqrt(a / b) if a > 0 and b > 0 else float("nan")


def mean(values):
    values = [v for v in values if not math.isnan(v)]
    return sum(values) / len(values) if values else float("nan")


def print_groups(results, region):
    """Means over the cases of a head, a skin or a light: the error of one case alone may be its noise."""
    print("| cases | number | shape-aware | off | lambert | on over off | nearer than lambert, off -> on |\n"
          "|---|---|---|---|---|---|---|")
    words = {case: case.rsplit("-", 2) for case in results}  # head, skin, light
    groups = [group for k in (2, 1, 0) for group in sorted({of_case[k] for of_case in words.values()})]
    for group in ["all", *groups]:
        rows = [errors(results[case], region) for case in results if group in ("all", *words[case])]
        rows = [row for row in rows if row]
        if not rows:
            continue
        on, off, lambert = (sum(row[k] for row in rows) / len(rows) for k in range(3))
        print(f"| {group} | {len(rows)} | {on:.2e} | {off:.2e} | {lambert:.2e} | {on / off:.2f} | "
              f"{root_ratio(lambert, off):.1f} -> {root_ratio(lambert, on):.1f} |")


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    results = {p.name.removesuffix(".result.json"): json.loads(p.read_text())
               for p in sorted(folder.glob("*.result.json"))}
    regions = ["skin"]
    if "--regions" in sys.argv:
        regions += ["nose", "terminator", "ears", "thin parts", "folds", "the rest"]
    for region in regions:
        print(f"**{region}**\n\n| case | noise % | shape-aware | off | lambert | on over off | "
              "nearer than lambert, off -> on |\n|---|---|---|---|---|---|---|")
        shares = []
        for case, result in results.items():
            e = errors(result, region)
            if e is None:
                continue
            shares.append(e[0] / e[1])
            print(f"| {case} | {noise_percent(folder, case):.1f} | {e[0]:.2e} | "
                  f"{e[1]:.2e} | {e[2]:.2e} | {e[0] / e[1]:.2f} | "
                  f"{root_ratio(e[2], e[1]):.1f} -> {root_ratio(e[2], e[0]):.1f} |")
        print(f"\n{len(shares)} cases, on over off: mean {mean(shares):.2f}, "
              f"largest {max(shares, default=0):.2f}\n")
        print_groups(results, region)


if __name__ == "__main__":
    main()
