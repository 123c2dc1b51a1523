# SPDX-License-Identifier: MIT
"""How long work tells how far it is."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

from . import _core

#: Called as f(what, share): the work that is done, and 0 to 1 of it. By any thread, never by two at a time.
#: Returning False ends the work (Cancelled); an exception ends it and reaches the caller.
Progress = Callable[[str, float], Any]


def progress_of(progress: Progress | bool | None) -> Progress | None:
    """True is a bar of tqdm."""
    if progress is None or progress is False:
        return None
    return _Bar() if progress is True else progress


class _Bar:
    """A bar of tqdm for each piece of work."""

    def __init__(self) -> None:
        try:
            tqdm: Any = importlib.import_module("tqdm.auto").tqdm
        except ImportError:
            raise _core.InputError("progress=True needs tqdm: pip install tqdm; or give a function") from None
        self._tqdm = tqdm
        self._bar: Any = None
        self._what = ""

    def __call__(self, what: str, share: float) -> None:
        if self._bar is None or what != self._what:
            if self._bar is not None:
                self._bar.close()
            self._bar, self._what = self._tqdm(total=100, desc=what, unit="%"), what
        self._bar.update(100 * share - self._bar.n)
        if share >= 1:
            self._bar.close()
            self._bar = None
