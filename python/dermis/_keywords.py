# SPDX-License-Identifier: MIT
"""Settings as keyword arguments, made of the rows that the command line's options are made of.

A keyword is called like the option, with '_' for '-': --map-size is map_size. Rows that share an option
or have none have the names of their members (cull, taps); width and height are one keyword, size=(width,
height).
"""

from __future__ import annotations

import json
import math
import os
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from . import _core

_pair = {"output.width": 0, "output.height": 1}


def names_of(rows: Sequence[_core.SettingRow]) -> dict[str, str]:
    """Returns the keyword of each path, but for width and height."""
    shared = Counter(row.option for row in rows)
    names = {}
    for row in rows:
        if row.path in _pair:
            continue
        own = row.path.rpartition(".")[2]
        names[row.path] = own if shared[row.option] > 1 or not row.option else row.option.replace("-", "_")
    return names


class Keywords:
    """The keywords of one structure of settings."""

    def __init__(self, rows: Sequence[_core.SettingRow]) -> None:
        names = names_of(rows)
        self.rows = {names[row.path]: row for row in rows if row.path in names}
        self.has_size = any(row.path in _pair for row in rows)
        # Longest first: a path may be the beginning of another one.
        self._paths = sorted(names.items(), key=lambda item: -len(item[0]))

    def json(self, function: str, given: Mapping[str, Any]) -> str:
        """Returns the settings as JSON. Raises TypeError for a keyword that is not known (names the
        nearest), InputError for a value that cannot be one."""
        sections: dict[str, Any] = {}
        for name, value in given.items():
            if name == "size" and self.has_size:
                width, height = _two(value)
                sections.setdefault("output", {}).update(width=width, height=height)
                continue
            row = self.rows.get(name)
            if row is None:
                raise TypeError(self._unknown(function, name))
            *parents, member = row.path.split(".")
            section = sections
            for parent in parents:
                section = section.setdefault(parent, {})
            section[member] = _value_of(name, row, value)
        return json.dumps(sections)

    def _unknown(self, function: str, name: str) -> str:
        known = [*self.rows, "size"] if self.has_size else list(self.rows)
        paths = {row.path.rpartition(".")[2]: keyword for keyword, row in self.rows.items()}
        near = paths.get(name) or _core.nearest(name, known)
        hint = f"; did you mean '{near}'?" if near else f"; there are: {', '.join(sorted(known))}"
        return f"{function}() got an unexpected keyword argument '{name}'{hint}"

    @contextmanager
    def named(self) -> Iterator[None]:
        """Errors inside name keywords in place of members."""
        try:
            yield
        except _core.InputError as error:
            raise _core.InputError(self.explained(str(error))) from None

    def explained(self, message: str) -> str:
        message = message.removeprefix("settings: ")
        for path, name in self._paths:
            message = re.sub(rf"(?<![\w.'-]){re.escape(path)}(?![\w-])", name, message)
        return message.replace("output.width", "size").replace("output.height", "size")


def _two(value: Any) -> tuple[Any, Any]:
    try:
        width, height = value
    except (TypeError, ValueError):
        raise _core.InputError(f"size must be two whole numbers, width and height, got {value!r}") from None
    return _plain("size", width), _plain("size", height)


def _plain(name: str, value: Any) -> Any:
    """Numbers of NumPy become Python's; paths become text."""
    if hasattr(value, "item") and getattr(value, "ndim", None) == 0:
        value = value.item()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, float) and not math.isfinite(value):
        raise _core.InputError(f"{name} must be finite, got {value}")
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    raise _core.InputError(f"{name} cannot be {_shown(value)}")


def _shown(value: Any) -> str:
    text = repr(value)
    return f"{type(value).__name__} {text if len(text) <= 60 else text[:57] + '...'}"


def _value_of(name: str, row: _core.SettingRow, value: Any) -> Any:
    kinds = _core.Kind
    if value is None:
        if row.optional:
            return None
        if row.kind in (kinds.text, kinds.texts):
            return ""
        raise _core.InputError(f"{name} cannot be None")
    if row.kind == kinds.lights:
        return [_light_of(name, light) for light in value]
    if row.kind == kinds.texts:
        return [_plain(name, text) for text in ([value] if isinstance(value, str) else value)]
    if row.kind == kinds.boolean and row.on and isinstance(value, str) and value in (row.on, row.off):
        return value == row.on
    if row.kind == kinds.whole and isinstance(value, float) and value.is_integer():
        return int(value)
    if row.count > 1:
        if isinstance(value, (str, bytes)) or not hasattr(value, "__len__") or len(value) != row.count:
            raise _core.InputError(f"{name} must be {row.count} numbers, got {_shown(value)}")
        return [_plain(name, number) for number in value]
    return _plain(name, value)


def _light_of(name: str, light: Any) -> dict[str, Any]:
    members = ("azimuth_deg", "elevation_deg", "irradiance")
    if isinstance(light, Mapping):
        return {str(key): _plain(name, value) for key, value in light.items()}
    values = list(light)
    if not 2 <= len(values) <= 3:
        raise _core.InputError(
            f"{name} must be a list of (azimuth, elevation) or (azimuth, elevation, irradiance), got "
            f"{_shown(light)}"
        )
    return {member: _plain(name, value) for member, value in zip(members, values)}


render_keywords = Keywords(_core.setting_rows())
asset_keywords = Keywords(_core.asset_rows())
reference_keywords = Keywords(_core.reference_rows())
profile_keywords = Keywords(_core.profile_rows())
skin_keywords = Keywords(_core.skin_rows())


def settings_of(function: str, given: Mapping[str, Any]) -> _core.RenderSettings:
    text = render_keywords.json(function, given)
    with render_keywords.named():
        return _core.render_settings(text)
