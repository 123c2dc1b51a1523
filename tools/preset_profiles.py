#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints src/tissue/gaussians/presets.inc: the profiles of `dermis profile --preset NAME`, to six digits.

    tools/preset_profiles.py build/release/dermis > src/tissue/gaussians/presets.inc
"""
import json
import subprocess
import sys
import tempfile
import textwrap

NAMES = ("apple chicken1 chicken2 cream ketchup marble potato skimmilk skin1 skin2 spectralon wholemilk "
         "skin-layers").split()


def rounded(value):
    if isinstance(value, float):
        return float(f"{value:.6g}")
    if isinstance(value, list):
        return [rounded(v) for v in value]
    if isinstance(value, dict):
        return {key: rounded(v) for key, v in value.items()}
    return value


def profile(program, name):
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        subprocess.run([program, "profile", "--preset", name, "-o", file.name], check=True,
                       stdout=subprocess.DEVNULL)
        return rounded(json.load(open(file.name)))


print("// SPDX-License-Identifier: MIT\n// Written by tools/preset_profiles.py: name, profile file.")
for name in NAMES:
    text = json.dumps(profile(sys.argv[1], name))
    print(f'{{"{name}", R"(\n' + "\n".join(textwrap.wrap(text, 108, break_on_hyphens=False)) + '\n)"},')
