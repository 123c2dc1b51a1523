# SPDX-License-Identifier: MIT
from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, Unpack

import numpy as np
from numpy.typing import NDArray

from . import _arrays, _core
from ._keywords import asset_keywords
from ._progress import Progress, progress_of
from ._types import AssetKeywords

Path = str | os.PathLike[str]


@dataclass
class Light:
    """A light, in relative units: irradiance pi on white Lambert shows as 1 (KHR_lights_punctual)."""

    type: Literal["directional", "spot", "point"] = "directional"
    colour: Sequence[float] = (1.0, 1.0, 1.0)
    """Linear Rec.709, at least 0: irradiance on a surface that faces the light; of spot and point at 1 m."""
    position_m: Sequence[float] = (0.0, 0.0, 0.0)
    direction: Sequence[float] = (0.0, 0.0, -1.0)
    """In which light travels (directional, spot); of any length but 0."""
    range_m: float = 0.0
    """Nothing arrives from further away (spot, point); 0: no limit."""
    inner_cone_deg: float = 0.0
    outer_cone_deg: float = 45.0
    radius: float = 0.0
    """Of a disc that faces the lit point, for soft shadows: m; directional: tangent of the angular
    radius."""
    name: str = ""

    def _to_core(self) -> _core.Light:
        light = _core.Light()
        if self.type not in _light_types:
            near = _core.nearest(self.type, list(_light_types))
            raise _core.InputError(
                f"type must be one of {', '.join(_light_types)}, got {self.type!r}"
                + (f"; did you mean {near!r}?" if near else "")
            )
        light.type = _light_types.index(self.type)
        light.name = self.name
        light.colour = three("colour", self.colour)
        light.position_m = three("position_m", self.position_m)
        light.direction = three("direction", self.direction)
        light.range_m = float(self.range_m)
        light.inner_cone_deg = float(self.inner_cone_deg)
        light.outer_cone_deg = float(self.outer_cone_deg)
        light.radius = float(self.radius)
        return light

    @classmethod
    def _of_core(cls, light: _core.Light) -> Light:
        return cls(
            type=_light_types[light.type],
            colour=tuple(light.colour),
            position_m=tuple(light.position_m),
            direction=tuple(light.direction),
            range_m=light.range_m,
            inner_cone_deg=light.inner_cone_deg,
            outer_cone_deg=light.outer_cone_deg,
            radius=light.radius,
            name=light.name,
        )


_light_types: tuple[Literal["directional", "spot", "point"], ...] = ("directional", "spot", "point")


@dataclass
class Material:
    """A metallic-roughness material of glTF 2.0. Maps are uint8 (H, W) or (H, W, 1 to 4)."""

    name: str = ""
    skin: bool | None = None
    """None: it is skin if "skin" is a word of its name, or if it is the only material in use."""
    base_colour: Sequence[float] = (1.0, 1.0, 1.0, 1.0)
    """Linear RGBA, 0 to 1; multiplies the map, which is sRGB."""
    base_colour_map: NDArray[Any] | None = None
    normal_map: NDArray[Any] | None = None
    """Tangent space, +Y up."""
    roughness: float = 0.5
    metallic: float = 0.0
    roughness_map: NDArray[Any] | None = None
    """Roughness in green, metallic in blue."""
    double_sided: bool = False


@dataclass
class Mesh:
    """Triangles of one material."""

    positions: Any
    """(N, 3), metres, +Y up; a head is 0.1 to 0.6 m high, because light spreads by mm."""
    indices: Any = None
    """(M, 3) or (3 M,), counter-clockwise seen from outside; None: each three vertices are a triangle."""
    normals: Any = None
    """(N, 3), of any length; None: they are computed."""
    uv: Any = None
    """(N, 2), v down. Skin without them is lit without scattering."""
    colours: Any = None
    """(N, 4), linear RGBA."""
    material: int = 0
    """Its place in the list of materials."""
    name: str = ""


@dataclass(frozen=True)
class Bounds:
    """Of the skin of an asset, or of all of it if nothing is skin; in its coordinates, metres."""

    low_m: NDArray[np.float64]
    high_m: NDArray[np.float64]
    centre_m: NDArray[np.float64]
    radius_m: float


class Asset:
    """A head with all that belongs to it. Copies share what it holds, nothing changes it, and threads may
    share it."""

    _inner: _core.Asset

    def __init__(self, core: _core.Asset) -> None:
        self._inner = core

    @classmethod
    def load(
        cls, path: Path, *, progress: Progress | bool | None = None, **options: Unpack[AssetKeywords]
    ) -> Asset:
        """Loads glTF 2.0 (.gltf, .glb), or makes the head that is built in: "built-in", "built-in:light",
        "built-in:medium", "built-in:dark". Takes seconds with large maps. Raises InputError (one line
        with file and place), Cancelled."""
        text = asset_keywords.json("Asset.load", options)
        with asset_keywords.named():
            return cls(_core.load_asset(named(path), text, progress_of(progress)))

    @classmethod
    def from_arrays(
        cls,
        meshes: Sequence[Mesh],
        materials: Sequence[Material] = (),
        *,
        name: str = "arrays",
        progress: Progress | bool | None = None,
        **options: Unpack[AssetKeywords],
    ) -> Asset:
        """Makes an asset of arrays of any real type, stride and byte order; copies them. Raises
        InputError: another shape or type, a value that is not finite, an index beyond the vertices."""
        text = asset_keywords.json("Asset.from_arrays", options)
        arrays = _core.ArrayAsset(name)
        for i, material in enumerate(materials):
            _add_material(arrays, material, f"materials[{i}]")
        for i, mesh in enumerate(meshes):
            _add_mesh(arrays, mesh, f"meshes[{i}]", len(materials))
        with asset_keywords.named():
            return cls(arrays.make(text, progress_of(progress)))

    @property
    def name(self) -> str:
        return self._inner.name

    @property
    def materials(self) -> list[str]:
        """Names; the label `material` is 1 + the place in this list."""
        return self._inner.materials

    @property
    def cameras(self) -> list[str]:
        return self._inner.cameras

    @property
    def clips(self) -> list[str]:
        return self._inner.clips

    @property
    def joints(self) -> list[str]:
        return self._inner.joints

    @property
    def morph_weights(self) -> list[str]:
        return self._inner.morph_weights

    def clip_end_s(self, clip: str) -> float:
        """Returns the time of the last key frame of a clip, seconds."""
        return self._inner.clip_end_s(clip)

    @property
    def lights(self) -> list[Light]:
        return [Light._of_core(light) for light in self._inner.lights()]

    @property
    def bounds(self) -> Bounds:
        low, high, centre, radius = self._inner.bounds()
        return Bounds(np.array(low), np.array(high), np.array(centre), radius)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Asset) and self._inner.same(other._inner)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<dermis.Asset {self.name!r}>"


def named(path: Path) -> str:
    text = os.fspath(path)
    return "built-in:medium" if text == "built-in" else text


def three(name: str, value: Any) -> list[float]:
    return some(name, value, 3) or []


def some(name: str, value: Any, count: int) -> list[float] | None:
    if value is None:
        return None
    array = np.asarray(value)
    if array.shape != (count,) or array.dtype.kind not in "fiu" or not np.isfinite(array).all():
        raise _core.InputError(f"{name} must be {count} finite numbers, got {value!r}")
    return [float(x) for x in array]


def _add_material(arrays: _core.ArrayAsset, material: Material, where: str) -> None:
    def image(name: str, value: Any) -> int:
        return -1 if value is None else arrays.add_image(name, _arrays.pixels(f"{where}.{name}", value))

    arrays.add_material(
        material.name,
        material.skin,
        some(f"{where}.base_colour", material.base_colour, 4) or [],
        float(material.roughness),
        float(material.metallic),
        image("base_colour_map", material.base_colour_map),
        image("normal_map", material.normal_map),
        image("roughness_map", material.roughness_map),
        bool(material.double_sided),
    )


def _add_mesh(arrays: _core.ArrayAsset, mesh: Mesh, where: str, materials: int) -> None:
    positions = _arrays.numbers(f"{where}.positions", mesh.positions, 3)
    rows = len(positions)
    if not -1 <= mesh.material < max(materials, 1):
        raise _core.InputError(f"{where}.material must be below the number of materials, got {mesh.material}")
    arrays.add_mesh(
        mesh.name,
        mesh.material if materials else -1,
        positions,
        None if mesh.indices is None else _arrays.whole_numbers(f"{where}.indices", mesh.indices),
        None if mesh.normals is None else _arrays.numbers(f"{where}.normals", mesh.normals, 3, rows),
        None if mesh.uv is None else _arrays.numbers(f"{where}.uv", mesh.uv, 2, rows),
        None if mesh.colours is None else _arrays.numbers(f"{where}.colours", mesh.colours, 4, rows),
    )
