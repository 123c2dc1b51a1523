# SPDX-License-Identifier: MIT
"""Diffusion profiles: of colours, tables and other systems' parameters; in the parameters of other systems.

>>> import dermis.profile
>>> skin = dermis.profile.of_colour("#c58c6d")
>>> dermis.profile.export(skin, "cycles")["parameters"]  # for Blender
"""

from __future__ import annotations

import importlib
import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._asset import Path
from ._keywords import profile_keywords
from ._profile import Profile
from ._progress import Progress, progress_of
from ._types import ProfileKeywords, SkinKeywords

__all__ = [
    "Curve",
    "Kernel",
    "curve",
    "export",
    "fit",
    "kernel",
    "kernels",
    "of_colour",
    "of_import",
    "plot",
    "skin_of_colour",
    "systems",
]

_channels = ("red", "green", "blue")


def fit(
    r_mm: Any,
    reflectance: Any,
    *,
    name: str = "table",
    progress: Progress | bool | None = None,
    **options: Unpack[ProfileKeywords],
) -> Profile:
    """Fits a profile to a table: R(r) in 1/mm^2, (N, 3) per channel of linear Rec.709, at radii r in mm,
    (N,), rising, N at least 2; linear between them. Raises InputError: another shape, a value that is not
    finite or below 0, a total over 1."""
    radii = _numbers("r_mm", r_mm)
    values = _numbers("reflectance", reflectance)
    if radii.ndim != 1 or values.shape != (len(radii), 3):
        raise _core.InputError(
            f"r_mm must have the shape (N,) and reflectance (N, 3), got {radii.shape} and {values.shape}"
        )
    text = profile_keywords.json("profile.fit", options)
    with profile_keywords.named():
        return Profile(
            _core.profile_of_table(name, radii.tolist(), values.tolist(), text, progress_of(progress))
        )


def skin_of_colour(colour: str) -> tuple[SkinKeywords, float]:
    """Returns the skin that is nearest to a colour, "#rrggbb" (sRGB) or "L,a,b" (CIELAB), as keywords of
    Profile.of_skin(), and how far it is (CIE76). Raises InputError for other text."""
    (melanin, blend, hemoglobin, oxygenation, epidermis_mm), delta_e = _core.skin_of_colour(colour)
    return {
        "melanin": melanin,
        "blend": blend,
        "hemoglobin": hemoglobin,
        "oxygenation": oxygenation,
        "epidermis_mm": epidermis_mm,
    }, delta_e


def of_colour(
    colour: str, *, progress: Progress | bool | None = None, **options: Unpack[ProfileKeywords]
) -> Profile:
    """Computes the profile of the skin that is nearest to a colour: see skin_of_colour(). Takes seconds."""
    skin, _ = skin_of_colour(colour)
    return Profile.of_skin(options=options, progress=progress, **skin)


def of_import(
    text: str, *, progress: Progress | bool | None = None, **options: Unpack[ProfileKeywords]
) -> Profile:
    """Computes the profile of parameters of another system: "unity reflectance=0.8,0.5,0.4
    scattering_distance=0.76,0.32,0.2", unreal, cycles, openpbr, gltf (docs/exports.md). Raises InputError:
    an unknown system or key, text whose unit is open (names its readings)."""
    how = profile_keywords.json("profile.of_import", options)
    with profile_keywords.named():
        return Profile(_core.profile_of_import(text, how, progress_of(progress)))


def systems() -> list[str]:
    """Returns what export() knows."""
    return _core.exchange_systems()


def export(profile: Profile, system: str) -> dict[str, Any]:
    """Returns a profile in the parameters of another system: "parameters" under its own names, "units", and
    "lost", what it cannot hold. "cycles" is Blender. Raises InputError for an unknown system (lists all)."""
    found: dict[str, Any] = json.loads(_core.export_profile(profile._inner, system))
    return found


@dataclass(frozen=True)
class Kernel:
    """A kernel for a shader."""

    name: str
    values: dict[str, Any]
    """Its tables and their units, as the JSON of `dermis profile --export` has them."""
    c: str
    """Arrays of C."""
    glsl: str

    def save(self, folder: Path) -> None:
        """Writes NAME.json, NAME.h and NAME.glsl into a folder that is there."""
        place = FilePath(os.fspath(folder))
        if not place.is_dir():
            raise _core.InputError(f"{place}: no such folder")
        table = json.dumps(self.values, indent=2) + "\n"
        for ending, text in (("json", table), ("h", self.c), ("glsl", self.glsl)):
            (place / f"{self.name}.{ending}").write_text(text)


def kernels() -> list[str]:
    """Returns what kernel() knows."""
    return _core.kernel_names()


def kernel(profile: Profile, name: str, *, taps: int | None = None) -> Kernel:
    """Returns the kernel of a technique (docs/exports.md): "separable-kernel" with 3 to 33 taps, odd,
    "burley-disc" with 1 to 4096, or "pre-integrated-tables". Raises InputError."""
    text, c, glsl = _core.export_kernel(profile._inner, name, taps)
    return Kernel(name, json.loads(text), c, glsl)


@dataclass(frozen=True)
class Curve:
    """R(r) as the model computed it, before the fit."""

    r_mm: NDArray[np.float64]
    """float64 (N,), rising, evenly in log r."""
    reflectance: NDArray[np.float64]
    """float64 (N, 3), 1/mm^2."""
    standard_error: NDArray[np.float64]
    """float64 (N, 3), 1/mm^2: the noise of Monte-Carlo; 0 of other models."""


def curve(profile: Profile) -> Curve:
    """Returns the curve behind a fit. Raises InputError: the profile was read from a file, which keeps the
    fit alone."""
    r_mm, reflectance, standard_error = _core.model_table(profile._inner)
    return Curve(np.array(r_mm), np.array(reflectance), np.array(standard_error))


def plot(profiles: Profile | Sequence[Profile], *, axes: Any = None) -> Any:
    """Draws r R(r) over r, mm, per channel, each divided by its total, so that shapes compare: the fit as a
    line, the curve of the model, where it is known, as dots. `axes`: of matplotlib; None: new ones.
    Returns them. Raises InputError without matplotlib."""
    if axes is None:
        try:
            axes = importlib.import_module("matplotlib.pyplot").subplots()[1]
        except ImportError:
            raise _core.InputError("plot() needs matplotlib: pip install matplotlib") from None
    all_of = [profiles] if isinstance(profiles, Profile) else list(profiles)
    for profile, line in zip(all_of, ("-", "--", ":", "-.") * (1 + len(all_of) // 4)):
        reach = 6 * float(np.sqrt(profile.variances_mm2[-1]))
        r = np.geomspace(1e-3 * reach, reach, 200)
        fitted = profile.reflectance(r)
        for c, colour in enumerate(_channels):
            total = profile.total_reflectance[c] or 1.0
            label = f"{profile.name}, {colour}"
            axes.plot(r, r * fitted[:, c] / total, line, color=colour, label=label)
            if profile._inner.has_curves:
                known = curve(profile)
                axes.plot(known.r_mm, known.r_mm * known.reflectance[:, c] / total, ".", color=colour, ms=2)
    axes.set_xscale("log")
    axes.set_xlabel("r, mm")
    axes.set_ylabel("r R(r) / total, 1/mm")
    axes.legend()
    return axes


def _numbers(name: str, value: Any) -> NDArray[np.float64]:
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise _core.InputError(f"{name} is no array: {error}") from None
    if array.dtype.kind not in "fiu":
        raise _core.InputError(f"{name} must be real numbers, got {array.dtype}")
    if not np.isfinite(array).all():
        raise _core.InputError(f"{name} must be finite")
    return array.astype(np.float64)
