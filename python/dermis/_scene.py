# SPDX-License-Identifier: MIT
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from . import _arrays, _core
from ._asset import Asset, Light, Path, named, some, three
from ._keywords import asset_keywords, render_keywords, settings_of
from ._profile import Profile
from ._progress import Progress, progress_of
from ._types import AssetKeywords, RenderKeywords

Clip = tuple[str, float]


@dataclass
class Pose:
    """What an instance shows of its clips, morph targets and joints."""

    clip: Clip | None = None
    """Name and time in seconds; None: as the asset was loaded."""
    second: Clip | None = None
    blend: float = 0.0
    """0 to 1, the share of `second`."""
    weights: Mapping[str, float] = field(default_factory=dict)
    """Of morph targets, by name: 0 none of it, 1 all of it."""
    joints: Mapping[str, Joint] = field(default_factory=dict)


@dataclass
class Joint:
    """Where a node stands against its parent; what is None stays as the clip has it."""

    translation: Sequence[float] | None = None
    rotation: Sequence[float] | None = None
    """Quaternion x y z w."""
    scale: Sequence[float] | None = None


@dataclass(frozen=True)
class Camera:
    """The camera of a picture as OpenCV has it. A point x of the world lies at c = R x + t (+x right, +y
    down, +z ahead; metres) and is seen at K c / c.z; without perspective at K (c.x, c.y, 1). The
    middle of the first pixel is at 0 0."""

    K: NDArray[np.float64]
    R: NDArray[np.float64]
    t: NDArray[np.float64]
    width: int
    height: int
    near_m: float
    orthographic: bool

    def project(self, points_m: Any) -> NDArray[np.float64]:
        """Returns float64 (N, 3): pixel x, pixel y and depth in metres of points of the world (N, 3)."""
        points = np.asarray(points_m, np.float64)
        if points.ndim != 2 or points.shape[1] != 3:
            raise _core.InputError(f"points_m must have the shape (N, 3), got {points.shape}")
        c = points @ self.R.T + self.t
        flat = np.column_stack([c[:, :2], np.ones(len(c))]) if self.orthographic else c / c[:, 2:]
        return np.column_stack([(flat @ self.K.T)[:, :2], c[:, 2]])


class Instance:
    """An asset in a scene. Writing to its members edits the scene; the next picture shows it."""

    def __init__(self, scene: _core.Scene, number: int) -> None:
        self._scene = scene
        self._id = number

    @property
    def name(self) -> str:
        return self._scene.instance_name(self._id)

    @property
    def asset(self) -> Asset:
        return Asset(self._scene.asset(self._id))

    @property
    def transform(self) -> NDArray[np.float64]:
        """float64 (4, 4), world from asset: multiplies columns from the left. A rotation times one
        positive scale, and a shift in metres."""
        return np.array(self._scene.transform(self._id)).reshape(4, 4).T

    @transform.setter
    def transform(self, value: Any) -> None:
        self._scene.set_transform(self._id, _arrays.matrix("transform", value))

    @property
    def visible(self) -> bool:
        return self._scene.visible(self._id)

    @visible.setter
    def visible(self, value: bool) -> None:
        self._scene.set_visible(self._id, bool(value))

    @property
    def tint(self) -> NDArray[np.float64]:
        """float64 (3,): multiplies the colour of the skin, linear, 0 to 100."""
        return np.array(self._scene.tint(self._id))

    @tint.setter
    def tint(self, value: Any) -> None:
        self._scene.set_tint(self._id, three("tint", value))

    @property
    def mix(self) -> float | None:
        """0 to 1: the part of the colour that acts before light scatters; None: the material's."""
        return self._scene.mix(self._id)

    @mix.setter
    def mix(self, value: float | None) -> None:
        self._scene.set_mix(self._id, None if value is None else float(value))

    @property
    def profile(self) -> Profile | None:
        """In place of that of the materials; None: theirs."""
        profile = self._scene.profile(self._id)
        return None if profile is None else Profile(profile)

    @profile.setter
    def profile(self, value: Profile | None) -> None:
        self._scene.set_profile(self._id, None if value is None else value._inner)

    def pose(self, pose: Pose | None = None, *, clip: str | None = None, time_s: float = 0.0) -> None:
        """Poses the instance: by a Pose, or by a clip at a time; without either as the asset was loaded.
        Raises InputError: a clip, joint or morph target that the asset does not have (lists those it
        has)."""
        if clip is not None:
            pose = Pose(clip=(clip, time_s))
        if pose is None:
            self._scene.clear_pose(self._id)
            return
        weights = [(name, float(weight)) for name, weight in pose.weights.items()]
        joints = [
            (
                name,
                some("translation", j.translation, 3),
                some("rotation", j.rotation, 4),
                some("scale", j.scale, 3),
            )
            for name, j in pose.joints.items()
        ]
        self._scene.set_pose(self._id, pose.clip, pose.second, float(pose.blend), weights, joints)

    def positions_m(self, vertices: Any, *, mesh: int = 0) -> NDArray[np.float64]:
        """Returns float64 (N, 3): where vertices stand in the world, posed, metres. Vertices have the
        numbers of their file or array. Raises InputError: no such mesh, a vertex that no triangle
        uses."""
        return self._scene.positions(self._id, mesh, _arrays.whole_numbers("vertices", vertices))

    def __repr__(self) -> str:
        return f"<dermis.Instance {self._id} of {self.asset.name!r}>"


class Scene:
    """Instances of assets, lights, surroundings. Edits are cheap: the next picture does the work. One
    thread at a time edits a scene."""

    _inner: _core.Scene

    def __init__(self, asset: Asset | None = None) -> None:
        """An empty scene, or one instance of the asset with the lights of its file."""
        self._inner = _core.Scene() if asset is None else _core.Scene(asset._inner)

    @classmethod
    def load(
        cls, path: Path, *, progress: Progress | bool | None = None, **options: Unpack[AssetKeywords]
    ) -> Scene:
        """Loads a scene file, or a glTF file as a scene of one instance; "built-in", "built-in:light",
        ... are heads of their own. Raises as Asset.load() does."""
        text = asset_keywords.json("Scene.load", options)
        with asset_keywords.named():
            return cls._of(_core.load_scene(named(path), text, progress_of(progress)))

    @classmethod
    def _of(cls, core: _core.Scene) -> Scene:
        scene = cls.__new__(cls)
        scene._inner = core
        return scene

    def copy(self) -> Scene:
        """Returns a scene that shares the assets, but no edits."""
        return Scene._of(self._inner.copy())

    def save(self, path: Path) -> None:
        """Writes a scene file, atomically; assets stay in their files."""
        self._inner.save(os.fspath(path))

    @property
    def name(self) -> str:
        return self._inner.name

    def add(self, asset: Asset, *, transform: Any = None, name: str = "") -> Instance:
        instance = Instance(self._inner, self._inner.add(asset._inner, name))
        if transform is not None:
            try:
                instance.transform = transform
            except _core.InputError:
                self._inner.remove(instance._id)
                raise
        return instance

    def remove(self, instance: Instance) -> None:
        self._inner.remove(instance._id)

    @property
    def instances(self) -> list[Instance]:
        """In the order of add(); the label `instance` is 1 + the place in this list."""
        return [Instance(self._inner, number) for number in self._inner.instances()]

    @property
    def lights(self) -> list[Light]:
        """Copies; set_lights() changes them."""
        return [Light._of_core(self._inner.light(number)) for number in self._inner.lights()]

    def set_lights(self, lights: Sequence[Light]) -> None:
        """Takes these in place of all lights of the scene. Raises InputError; the scene is then as
        before."""
        before = self._inner.lights()
        added: list[int] = []
        try:
            for light in lights:
                added.append(self._inner.add_light(light._to_core()))
        except Exception:
            for number in added:
                self._inner.remove_light(number)
            raise
        for number in before:
            self._inner.remove_light(number)

    def add_light(self, light: Light) -> None:
        self._inner.add_light(light._to_core())

    def set_environment(self, environment: Path | Any | None) -> None:
        """Surroundings: the name of a picture (.hdr, .exr, "studio"), linear radiance as an array (H, W,
        3), twice as wide as high, or None."""
        if environment is None or isinstance(environment, (str, os.PathLike)):
            self._inner.set_environment(None if environment is None else os.fspath(environment), None)
        else:
            self._inner.set_environment(None, _arrays.radiance("environment", environment))

    def camera(self, **settings: Unpack[RenderKeywords]) -> Camera:
        """Returns the camera of a picture with these settings. Needs no device."""
        with render_keywords.named():
            k, r, t, width, height, near_m, orthographic = self._inner.camera(
                settings_of("Scene.camera", settings)
            )
        return Camera(
            np.array(k).reshape(3, 3),
            np.array(r).reshape(3, 3),
            np.array(t),
            width,
            height,
            near_m,
            orthographic,
        )

    def __repr__(self) -> str:
        return f"<dermis.Scene {self.name!r}>"
