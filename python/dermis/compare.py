# SPDX-License-Identifier: MIT
"""How far pictures are apart, and the techniques of a scene from its ground truth.

>>> import dermis.compare
>>> table = dermis.compare.techniques(scene, ["texture-space", "lambert"], size=(96, 96), exposure=0)
>>> for row in table.rows:
...     print(row.technique, row.region, row.relative_mse)
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, fields
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from . import _arrays, _core
from ._asset import Asset, Path
from ._keywords import reference_keywords, render_keywords, settings_of
from ._progress import Progress, progress_of
from ._renderer import Picture, _scene_of
from ._scene import Scene
from ._types import ReferenceKeywords, RenderKeywords
from .reference import Reference

__all__ = ["Comparison", "Flip", "Point", "Row", "flip", "psnr_db", "regions", "relative_mse", "techniques"]


@dataclass(frozen=True)
class Flip:
    """FLIP of two pictures: how large their difference looks, 0 (none) to 1."""

    mean: float
    """Over the mask."""
    map: NDArray[np.float32]
    """float32 (H, W)."""
    exposures: tuple[float, float, int] | None = None
    """Of linear light: from, to and how many exposures the reference was shown at, stops."""

    def __float__(self) -> float:
        return self.mean


def flip(reference: Any, test: Any, *, mask: Any = None) -> Flip:
    """Returns FLIP (Andersson et al. 2020) of display values, uint8 (H, W, 3 or 4), or HDR-FLIP (Andersson
    et al. 2021) of linear light, float (H, W, 3 or 4). The fourth channel does not count. `mask`: bool
    (H, W), which pixels the mean is over. The screen has 67 pixels per degree. Pictures may be given as
    they are: their display values are compared. Raises InputError: another type or shape, sizes that
    differ, a value that is not finite, an empty mask."""
    a, b = _pair(reference, test)
    counted = _mask(mask)
    found = (_core.flip_display if a.dtype == np.uint8 else _core.flip_linear)(a, b, counted)
    exposures = (found.start_exposure, found.stop_exposure, found.exposures) if found.exposures else None
    return Flip(found.mean, found.map(), exposures)


def psnr_db(reference: Any, test: Any, *, mask: Any = None) -> float:
    """Returns 10 log10(255^2 / mean squared difference) of display values, uint8 (H, W, 3 or 4), dB; 100
    for equal pictures. Raises InputError as flip() does."""
    a, b = _pair(reference, test)
    if a.dtype != np.uint8:
        raise _core.InputError("reference must be uint8, as a display shows it, got float")
    return _core.psnr_db(a, b, _mask(mask))


def relative_mse(reference: Any, test: Any, *, variance: Any = None, mask: Any = None) -> float:
    """Returns the mean of (test - reference)^2 / (reference^2 + 0.01) over R, G and B of linear light, float
    (H, W, 3 or 4) (Rousselle et al. 2011). With `variance`, the squares of the standard errors of the
    reference (Reference.variance): an estimate of the error against a reference without noise, which may
    fall below 0. Raises InputError as flip() does."""
    a, b = _pair(reference, test, linear=True)
    if a.dtype == np.uint8:
        raise _core.InputError("reference must be linear light, float, got uint8")
    noise = None if variance is None else _arrays.light("variance", variance)
    return _core.relative_mse(a, b, noise, _mask(mask))


def regions(
    scene: Scene | Asset | Path,
    *,
    progress: Progress | bool | None = None,
    **settings: Unpack[RenderKeywords],
) -> dict[str, NDArray[np.bool_]]:
    """Returns the parts of a picture where techniques differ from the truth for different reasons, bool
    (H, W) each: skin, ears, nose, terminator, shadow edges, thin parts, folds, seams, the rest. Needs no
    device. Raises InputError, Cancelled."""
    of_render = settings_of("compare.regions", settings)
    output = json.loads(of_render.json)["output"]
    with render_keywords.named():
        found = _core.picture_regions(_scene_of(scene)._inner, of_render, progress_of(progress))
    return {r.name: r.mask(output["width"], output["height"]).astype(bool) for r in found}


@dataclass(frozen=True)
class Row:
    """The error of one technique in one region."""

    technique: str
    """As people read it: "texture-space, one Gaussian"."""
    region: str
    pixels: int
    flip: float
    """Mean, of display values."""
    hdr_flip: float
    """Mean, of linear light."""
    psnr_db: float
    relative_mse: float
    relative_mse_less_noise: float | None
    """Less what the noise of the reference adds; None where its variance is not known."""
    share: float
    """Of the summed FLIP over skin, 0 to 1."""
    frame_ms: float
    """Median of the frames of this technique, drawn in turns with the others."""


@dataclass(frozen=True)
class Point:
    """A technique with one of its quality settings, over skin."""

    curve: str
    setting: str
    frame_ms: float
    taps_per_pixel: float
    relative_mse: float
    """Of larger pictures, averaged down."""
    relative_mse_at_size: float
    """Of the picture that took this time."""


class Comparison:
    """Every technique against the truth."""

    def __init__(self, core: _core.SceneComparison) -> None:
        self._inner = core
        self.names = [core.technique_name(i) for i in range(core.technique_count())]
        self.regions: dict[str, NDArray[np.bool_]] = {
            core.region_name(i): core.region_mask(i).astype(bool) for i in range(core.region_count())
        }
        """bool (H, W) each; "skin" first."""
        self.rows: list[Row] = list(self._rows())
        """One per technique and region that is not empty; pandas.DataFrame(rows) takes them."""
        self.noise: list[Row] = [] if core.noise is None else list(self._row("noise", core.noise, 0.0))
        """The same of the reference against itself with noise of its variance: what is below cannot be
        seen."""
        self.curves = [
            Point(p.curve, p.label, p.ms, p.taps_per_pixel, p.error.rel_mse, p.at_size.rel_mse)
            for p in core.curves
        ]
        """With curves=True: each technique with its own quality settings."""

    def _rows(self) -> Iterator[Row]:
        core = self._inner
        for i, name in enumerate(self.names):
            yield from self._row(name, core.technique_errors(i), core.technique_ms(i))

    def _row(self, name: str, errors: Iterable[_core.RegionError | None], ms: float) -> Iterator[Row]:
        for (region, mask), e in zip(self.regions.items(), errors):
            if e is not None:
                yield Row(
                    name,
                    region,
                    int(mask.sum()),
                    e.flip,
                    e.hdr_flip,
                    e.psnr_db,
                    e.rel_mse,
                    e.rel_mse_unbiased,
                    e.share,
                    ms,
                )

    def row(self, technique: str, region: str = "skin") -> Row:
        """Returns one row. Raises KeyError: no such technique, or its region is empty."""
        for row in self.rows:
            if row.technique == technique and row.region == region:
                return row
        raise KeyError(f"no row of {technique!r} over {region!r}; techniques: {', '.join(self.names)}")

    def display(self, technique: str | None = None) -> NDArray[np.uint8]:
        """Returns uint8 (H, W, 4) of a technique, averaged down; None: of the reference."""
        return (
            self._inner.reference_display()
            if technique is None
            else self._inner.technique_display(self._number_of(technique))
        )

    def flip_map(self, technique: str) -> NDArray[np.float32]:
        """Returns float32 (H, W): FLIP of display() against the reference."""
        return self._inner.technique_flip(self._number_of(technique))

    def statistics(self, technique: str) -> dict[str, Any]:
        """Returns what was drawn and what it cost, as Picture.statistics."""
        found: dict[str, Any] = json.loads(self._inner.technique_statistics(self._number_of(technique)))
        return found

    def _number_of(self, technique: str) -> int:
        if technique not in self.names:
            near = _core.nearest(technique, self.names)
            hint = f"did you mean {near!r}?" if near else f"there are: {', '.join(self.names)}"
            raise KeyError(f"{technique!r} was not compared; {hint}")
        return self.names.index(technique)

    @property
    def exposure(self) -> float:
        """Of all pictures, stops."""
        return self._inner.exposure_ev

    @property
    def samples(self) -> int:
        """Of the reference, per pixel."""
        return self._inner.samples

    @property
    def noise_percent(self) -> float:
        """Mean standard error of the reference over skin, per cent of the mean."""
        return self._inner.noise_percent

    def _repr_html_(self) -> str:
        names = [f.name for f in fields(Row)]
        head = "".join(f"<th>{name}</th>" for name in names)
        body = "".join(
            "<tr>" + "".join(f"<td>{_shown(getattr(row, name))}</td>" for name in names) + "</tr>"
            for row in self.rows
        )
        return f"<table><tr>{head}</tr>{body}</table>"

    def __repr__(self) -> str:
        return f"<dermis.compare.Comparison of {', '.join(self.names)}>"


def techniques(
    scene: Scene | Asset | Path,
    techniques: str | Iterable[str] = (),
    *,
    truth: Reference | None = None,
    reference: ReferenceKeywords | None = None,
    supersample: int = 4,
    one_gaussian: bool = False,
    each_optimisation: bool = False,
    curves: bool = False,
    device: str = "best",
    progress: Progress | bool | None = None,
    **settings: Unpack[RenderKeywords],
) -> Comparison:
    """Draws the scene by each technique (none named: all that can draw it) and compares with ground truth:
    `truth`, which dermis.reference.render() has made with the same settings, or one that is computed now
    as `reference` says. Errors are of pictures `supersample` times as wide and high, averaged down; times
    are those of pictures of `size`, `frames` of each, in turns. `one_gaussian`, `each_optimisation`:
    further rows. `curves`: further points with the quality settings that each technique has. Raises
    InputError (an unknown technique names the nearest; a truth of another size; no skin in the picture),
    DeviceError, Cancelled."""
    names = [techniques] if isinstance(techniques, str) else list(techniques)
    given: Any = {"bloom": 0.0, **settings}  # the truth has none
    how = reference_keywords.json("compare.techniques", reference or {})
    of_render = settings_of("compare.techniques", given)
    with render_keywords.named(), reference_keywords.named():
        return Comparison(
            _core.compare_scene(
                _scene_of(scene)._inner,
                of_render,
                how,
                names,
                supersample,
                one_gaussian,
                each_optimisation,
                curves,
                None if truth is None else truth._reference,
                device,
                progress_of(progress),
            )
        )


def _pair(reference: Any, test: Any, *, linear: bool = False) -> tuple[NDArray[Any], NDArray[Any]]:
    a, b = (
        _arrays.picture(name, _values(value, linear))
        for name, value in (("reference", reference), ("test", test))
    )
    if a.dtype != b.dtype:
        raise _core.InputError(
            f"reference is {a.dtype} and test is {b.dtype}: display values (uint8) and linear light (float) "
            "cannot be compared"
        )
    if a.shape[:2] != b.shape[:2]:
        raise _core.InputError(f"test has the shape {b.shape}, reference {a.shape}")
    return a, b


def _values(value: Any, linear: bool) -> Any:
    if isinstance(value, Picture):
        return value.linear if linear else value.display
    return value


def _mask(mask: Any) -> NDArray[np.uint8] | None:
    if mask is None:
        return None
    array = np.asarray(mask)
    if array.ndim != 2 or array.dtype.kind not in "biu":
        raise _core.InputError(f"mask must be bool (H, W), got {array.dtype} {array.shape}")
    return np.ascontiguousarray(array != 0).view(np.uint8)


def _shown(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else "" if value is None else str(value)
