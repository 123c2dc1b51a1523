# SPDX-License-Identifier: MIT
"""Writes dermis/_types.py from the rows of the settings: the types of all keywords, for checkers and
editors.

usage: write_types.py FOLDER_OF_CORE OUTPUT
"""

import sys

sys.path.insert(0, sys.argv[1])

import _core  # noqa: E402


def type_of(row):
    kind = row.kind.name
    if row.count > 1:
        text = "Numbers"
    elif kind == "choice":
        text = "Literal[" + ", ".join(f'"{choice}"' for choice in row.choices) + "]"
    elif kind == "boolean":
        text = f'bool | Literal["{row.on}", "{row.off}"]' if row.on else "bool"
    else:
        text = {
            "text": "str | os.PathLike[str]",
            "texts": "str | Sequence[str]",
            "number": "SupportsFloat",
            "whole": "SupportsIndex",
            "lights": "Sequence[Numbers | Mapping[str, float]]",
        }[kind]
    return text + (" | None" if row.optional else "")


def about(row):
    text = row.help
    if row.count == 1 and row.kind.name in ("number", "whole"):
        finite = abs(row.least) < float("inf") and abs(row.most) < float("inf")
        if finite:
            text += f"; {row.least:g} to {row.most:g}"
        if row.unit:
            text += f" {row.unit}" if finite else f"; {row.unit}"
    if row.none:
        text += f". None or empty: {row.none}"
    elif row.initial not in ("null", '""', "[]"):
        text += f". Default: {row.initial.strip(chr(34))}"
    return text.replace("\\", "\\\\").replace('"""', "'''")


def shared(rows, row):
    return sum(other.option == row.option for other in rows) > 1


def keywords(title, doc, rows, size):
    lines = [f"class {title}(TypedDict, total=False):", f'    """{doc}"""', ""]
    if size:
        lines += ["    size: Numbers", '    """Width and height of the picture, pixels."""']
    for row in rows:
        if row.path in ("output.width", "output.height"):
            continue
        member = row.path.rpartition(".")[2]
        name = member if shared(rows, row) or not row.option else row.option.replace("-", "_")
        lines += [f"    {name}: {type_of(row)}", f'    """{about(row)}"""']
    return "\n".join(lines)


parts = [
    '''# SPDX-License-Identifier: MIT
"""The types of keywords; written by write_types.py from the rows of the settings."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, Literal, SupportsFloat, SupportsIndex, TypedDict

from numpy.typing import NDArray

Numbers = Sequence[float] | NDArray[Any]
''' + "OutputName = Literal[" + ", ".join(f'"{row[0]}"' for row in _core.output_rows()) + "]",
    keywords("RenderKeywords", "Settings of a picture.", _core.setting_rows(), True),
    keywords("AssetKeywords", "How an asset is read.", _core.asset_rows(), False),
    keywords("ReferenceKeywords", "How ground truth is computed.", _core.reference_rows(), False),
    keywords("ProfileKeywords", "How a profile is computed.", _core.profile_rows(), False),
    keywords("SkinKeywords", "What skin is made of.", _core.skin_rows(), False),
]
with open(sys.argv[2], "w", encoding="utf-8") as out:
    out.write("\n\n\n".join(parts) + "\n")
