# SPDX-License-Identifier: MIT
from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._keywords import profile_keywords, skin_keywords
from ._progress import Progress, progress_of
from ._types import ProfileKeywords, SkinKeywords

Path = str | os.PathLike[str]


class Profile:
    """A diffusion profile as a sum of Gaussians: how much light leaves skin at a distance r from where it
    entered.

    R(r) = total * sum_i w_i exp(-r^2 / (2 v_i)) / (2 pi v_i), r in mm, per channel of linear Rec.709
    (d'Eon and Luebke 2007, chapter 14; Jimenez and Gutierrez 2008, equation 2).
    """

    _inner: _core.Profile

    def __init__(self, core: _core.Profile) -> None:
        self._inner = core

    @classmethod
    def load(cls, name: Path, *, normalise: bool = False) -> Profile:
        """Loads a published profile ("skin") or a profile file. Raises InputError."""
        return cls(_core.load_profile(os.fspath(name), normalise))

    @classmethod
    def preset(
        cls, name: str, *, progress: Progress | bool | None = None, **options: Unpack[ProfileKeywords]
    ) -> Profile:
        """Computes the profile of a measured material, such as "skin1" or "skin-layers" (Jensen et al.
        2001). Takes 10 ms by the dipole, seconds by Monte-Carlo. Raises InputError for an unknown name
        (lists all)."""
        text = profile_keywords.json("Profile.preset", options)
        with profile_keywords.named():
            return cls(_core.profile_of_preset(name, text, progress_of(progress)))

    @classmethod
    def of_skin(
        cls,
        *,
        options: ProfileKeywords | None = None,
        progress: Progress | bool | None = None,
        **skin: Unpack[SkinKeywords],
    ) -> Profile:
        """Computes the profile of spectral skin: melanin, blend, hemoglobin, oxygenation, epidermis_mm
        (Donner and Jensen 2006). Takes seconds. Raises InputError for a value out of range."""
        how = profile_keywords.json("Profile.of_skin", options or {})
        text = skin_keywords.json("Profile.of_skin", skin)
        with profile_keywords.named(), skin_keywords.named():
            return cls(_core.profile_of_skin(text, how, progress_of(progress)))

    @classmethod
    def of_coefficients(
        cls,
        sigma_a_per_mm: Sequence[float],
        sigma_s_per_mm: Sequence[float],
        *,
        g: float = 0.0,
        eta: float = 1.4,
        progress: Progress | bool | None = None,
        **options: Unpack[ProfileKeywords],
    ) -> Profile:
        """Computes the profile of a half-space: absorption and scattering per mm and channel, the mean
        cosine g of the phase function, the refractive index eta. Raises InputError for a value out of
        range."""
        text = profile_keywords.json("Profile.of_coefficients", options)
        absorption, scattering = (
            _three(name, value)
            for name, value in (("sigma_a_per_mm", sigma_a_per_mm), ("sigma_s_per_mm", sigma_s_per_mm))
        )
        with profile_keywords.named():
            return cls(
                _core.profile_of_coefficients(
                    absorption, scattering, float(g), float(eta), text, progress_of(progress)
                )
            )

    @property
    def name(self) -> str:
        return self._inner.name

    @property
    def model(self) -> str:
        """Which model made it: dipole, multipole, monte-carlo, ...; empty of published ones."""
        return self._inner.model

    @property
    def variances_mm2(self) -> NDArray[np.float64]:
        """float64 (N,), rising: v_i."""
        return np.array(self._inner.variances_mm2)

    @property
    def weights(self) -> NDArray[np.float64]:
        """float64 (N, 3): w_i per channel, which sum to 1."""
        return np.array(self._inner.weights)

    @property
    def total_reflectance(self) -> NDArray[np.float64]:
        """float64 (3,), 0 to 1."""
        return np.array(self._inner.total_reflectance)

    @property
    def mean_free_path_mm(self) -> NDArray[np.float64]:
        """float64 (3,)."""
        return np.array(self._inner.mean_free_path_mm)

    @property
    def error_percent(self) -> NDArray[np.float64]:
        """float64 (3,): of the fit."""
        return np.array(self._inner.error_percent)

    def reflectance(self, r_mm: Any) -> NDArray[np.float64]:
        """Returns R(r) in 1/mm^2, float64 (..., 3), of distances of any shape, mm, at least 0."""
        r = np.asarray(r_mm, np.float64)
        if not np.isfinite(r).all() or (r < 0).any():
            raise _core.InputError("r_mm must be finite and at least 0")
        values = [self._inner.reflectance(float(x)) for x in r.reshape(-1)]
        return np.array(values, np.float64).reshape((*r.shape, 3))

    def save(self, path: Path) -> None:
        """Writes the file that render(profile=...) and `dermis render --profile` take, atomically."""
        self._inner.save(os.fspath(path))

    def __repr__(self) -> str:
        return f"<dermis.Profile {self.name!r}, {len(self._inner.variances_mm2)} Gaussians>"


def _three(name: str, value: Any) -> list[float]:
    array = np.asarray(value, np.float64)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise _core.InputError(f"{name} must be three finite numbers, got {value!r}")
    return [float(x) for x in array]
