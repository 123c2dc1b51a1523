# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from . import _core


def part_names() -> tuple[str, ...]:
    """Returns the names of the numbers in the labels `part` and `front_part`. Right and left are the
    person's."""
    return tuple(row[0] for row in _core.part_rows())


def part_classes(data_set: Literal["FaceSynthetics", "CelebAMask-HQ"]) -> NDArray[np.uint8]:
    """Returns uint8 (16,): the class of each part in a data set of others. Where it has none: 255, which
    FaceSynthetics ignores; 0, the background, of CelebAMask-HQ, whose `l_` is taken for the person's left.
    Raises InputError: another data set.

    >>> classes = dermis.part_classes("FaceSynthetics")[frame.part]
    """
    columns = {"FaceSynthetics": 1, "CelebAMask-HQ": 2}
    if data_set not in columns:
        near = _core.nearest(data_set, list(columns))
        raise _core.InputError(
            f"there is no table to '{data_set}'"
            + (f"; did you mean '{near}'?" if near else f"; there are: {', '.join(columns)}")
        )
    return np.array([row[columns[data_set]] for row in _core.part_rows()], np.uint8)
