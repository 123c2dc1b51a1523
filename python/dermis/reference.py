# SPDX-License-Identifier: MIT
"""Ground truth on the CPU: the same scene, camera, lights and coefficients, without the approximations of
real time."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._asset import Asset, Path
from ._keywords import reference_keywords, render_keywords, settings_of
from ._progress import Progress, progress_of
from ._renderer import Picture, _scene_of
from ._scene import Scene
from ._types import ReferenceKeywords, RenderKeywords

__all__ = ["Progress", "Reference", "SampleProgress", "render"]


@dataclass(frozen=True)
class SampleProgress:
    """How far a run is."""

    samples: int
    most_samples: int
    noise_percent: float
    """Mean standard error over skin, per cent of the mean."""
    seconds_left: float


class Reference(Picture):
    """The truth, and how far to trust it."""

    def __init__(self, core: _core.ReferencePicture) -> None:
        super().__init__(core.picture)
        self._reference = core

    @property
    def variance(self) -> NDArray[np.float32]:
        """float32 (H, W, 4): the square of the standard error of each value of `linear`; 0 below 16
        samples."""
        return self._reference.variance

    @property
    def samples(self) -> int:
        return self._reference.samples

    @property
    def noise_percent(self) -> float:
        return self._reference.noise_percent

    @property
    def complete(self) -> bool:
        """False: a progress function has ended the work."""
        return self._reference.complete

    def __repr__(self) -> str:
        return f"<dermis.reference.Reference {self.width} x {self.height}, {self.samples} samples>"


def render(
    scene: Scene | Asset | Path,
    *,
    reference: ReferenceKeywords | None = None,
    checkpoint: Path | None = None,
    resume: bool = False,
    after_sample: Callable[[SampleProgress], Any] | None = None,
    progress: Progress | bool | None = None,
    **settings: Unpack[RenderKeywords],
) -> Reference:
    """Computes the truth; takes minutes to hours. `reference`: model, medium, samples, noise, seed,
    threads. The picture depends on settings and seed alone. `checkpoint`: a file, written every half
    minute and when the work is ended, also by Ctrl-C; `resume` goes on from it. `after_sample` hears
    of each sample of all pixels; returning False ends the work with the samples that there are.
    `exposure` must be a number. Raises InputError, DeviceError, Cancelled, TypeError for a keyword
    that is not known."""
    how = reference_keywords.json("reference.render", reference or {})
    of_render = settings_of("reference.render", settings)

    def hear(samples: int, most_samples: int, noise_percent: float, seconds_left: float) -> Any:
        assert after_sample is not None
        return after_sample(SampleProgress(samples, most_samples, noise_percent, seconds_left))

    with render_keywords.named(), reference_keywords.named():
        return Reference(
            _core.render_reference(
                _scene_of(scene)._inner,
                of_render,
                how,
                "" if checkpoint is None else os.fspath(checkpoint),
                resume,
                None if after_sample is None else hear,
                progress_of(progress),
            )
        )
