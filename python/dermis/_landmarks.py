# SPDX-License-Identifier: MIT
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._asset import Asset, Path
from ._scene import Camera, Instance


@dataclass(frozen=True)
class LandmarkPlace:
    """A point of a triangle: the mean of its corners by these weights."""

    mesh: int
    triangle: tuple[int, int, int]
    """Vertices, with the numbers of their file or array."""
    weights: tuple[float, float, float]


@dataclass(frozen=True)
class PictureLandmarks:
    """Landmarks in a picture."""

    pixels: NDArray[np.float64]
    """(70, 2): x and y, the middle of the first pixel at 0 0. May lie outside the picture; NaN nearer than
    the near plane."""
    depth: NDArray[np.float64]
    """(70,): metres along the axis of the camera."""
    seen: NDArray[np.bool_]
    """(70,): the picture shows the point. One of the four pixels around it has its depth within 1 mm, or
    within the change of depth to the next pixel where that is more. Lashes and brows hide nothing."""
    positions_m: NDArray[np.float64]
    """(70, 3): in the world, posed, metres."""


class Landmarks:
    """68 points of a face as iBUG numbers them, then the right and the left pupil: the 70 of FaceSynthetics.
    Right and left are the person's. They are fixed to triangles and follow poses; iBUG's jaw line slides
    along the outline, and this one does not.

    >>> marks = dermis.Landmarks.of(scene.instances[0].asset)
    >>> found = marks.in_picture(scene.instances[0], scene.camera(**view), frame.depth)
    >>> found.pixels[found.seen]
    """

    _inner: _core.Landmarks

    def __init__(self, core: _core.Landmarks) -> None:
        self._inner = core

    @classmethod
    def of(cls, asset: Asset) -> Landmarks | None:
        """Returns those of the built-in head, of NAME.landmarks.json beside the asset's file, or of a head
        that dermis knows by its triangles; None: there are none. Raises InputError: the file is faulty, or
        of another head."""
        found = _core.landmarks_of(asset._inner)
        return None if found is None else cls(found)

    @classmethod
    def load(cls, asset: Asset, path: Path) -> Landmarks:
        """Reads them from a file. Raises InputError as of() does."""
        return cls(_core.load_landmarks(asset._inner, os.fspath(path)))

    @property
    def places(self) -> list[LandmarkPlace]:
        """70 places."""
        return [
            LandmarkPlace(mesh, (a, b, c), (u, v, w))
            for mesh, (a, b, c), (u, v, w) in self._inner.places()
        ]

    def positions_m(self, instance: Instance) -> NDArray[np.float64]:
        """Returns float64 (70, 3): where they stand in the world, posed, metres. Raises InputError: an
        instance of another asset."""
        return np.array(self._inner.positions(instance._scene, instance._id), np.float64)

    def in_picture(self, instance: Instance, camera: Camera, depth: Any) -> PictureLandmarks:
        """Returns where a picture shows them. `depth`: its label, float32 (H, W). Raises InputError: as
        positions_m() does; another shape than the camera's picture."""
        shown = np.ascontiguousarray(depth, np.float32)
        if shown.shape != (camera.height, camera.width):
            wanted = (camera.height, camera.width)
            raise _core.InputError(f"depth must have the shape of the picture, {wanted}, got {shown.shape}")
        core = _core.ResolvedCamera()
        core.orthographic = camera.orthographic
        core.width, core.height, core.near_m = camera.width, camera.height, camera.near_m
        core.k = [float(x) for x in np.asarray(camera.K).reshape(9)]
        core.r = [float(x) for x in np.asarray(camera.R).reshape(9)]
        core.t_m = [float(x) for x in np.asarray(camera.t).reshape(3)]
        found = self._inner.in_picture(instance._scene, instance._id, core, shown)
        x, y, z, seen, positions = zip(*found, strict=True)
        return PictureLandmarks(
            np.column_stack([x, y]), np.array(z), np.array(seen, np.bool_), np.array(positions)
        )
