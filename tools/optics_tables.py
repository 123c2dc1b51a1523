#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes src/tissue/optics/haemoglobin.inc and src/tissue/optics/observer.inc from two CSV files.

usage: tools/optics_tables.py HAEMOGLOBIN.csv CIE.csv

HAEMOGLOBIN.csv: wavelength_nm,HbO2,Hb in cm^-1/(mol/L) per tetramer
                 (S. Prahl, omlc.org, from W. B. Gratzer and N. Kollias)
CIE.csv: wavelength_nm,xbar,ybar,zbar,D65 (CIE 015)
"""
import sys
from pathlib import Path

here = Path(__file__).resolve().parent.parent / "src" / "optics"


def write(source, target, first, last, comment):
    rows = []
    for line in Path(source).read_text().splitlines():
        if not line or line.startswith("#") or line.startswith("wavelength"):
            continue
        values = line.split(",")
        if first <= float(values[0]) <= last:
            rows.append("{" + ", ".join(values) + "},")
    head = "// SPDX-License-Identifier: MIT\n// Made by tools/optics_tables.py. " + comment
    text = "\n".join([head, "// clang-format off", *rows, "// clang-format on", ""])
    (here / target).write_text(text)
    print(target, len(rows), "rows")


if len(sys.argv) != 3:
    sys.exit(__doc__)
write(sys.argv[1], "haemoglobin.inc", 380, 780,
      "Columns: nm, HbO2, Hb [cm^-1/(mol/L)], per tetramer of 64500 g/mol.\n"
      "// Source: S. Prahl, Tabulated Molar Extinction Coefficient for Hemoglobin in Water, omlc.org, 1998, "
      "from W. B. Gratzer and N. Kollias.")
write(sys.argv[2], "observer.inc", 380, 780,
      "Columns: nm, xbar, ybar, zbar (CIE 1931 2-degree observer), D65 (relative power).\n"
      "// Source: CIE 015, Colorimetry.")
