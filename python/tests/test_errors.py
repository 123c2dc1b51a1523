# SPDX-License-Identifier: MIT
"""What is wrong is refused in one line that names it; what is only written otherwise is taken."""

from typing import Any

import numpy as np
import pytest
from conftest import small, square

import dermis


def test_a_wrong_keyword_names_the_nearest(scene: dermis.Scene) -> None:
    def refused(**keywords: Any) -> str:
        with pytest.raises(TypeError) as error:
            dermis.render(scene, **keywords)
        return str(error.value)

    assert refused(map_sizes=3).endswith("'map_sizes'; did you mean 'map_size'?")
    assert refused(fov_deg=30).endswith("did you mean 'fov'?"), "the name of the member"
    assert "there are: " in refused(quantum=3)
    with pytest.raises(TypeError, match="did you mean 'unit_scale'"):
        dermis.Asset.load("built-in", unit_scal=2)  # type: ignore[call-arg]


@pytest.mark.parametrize(
    "keywords, message",
    [
        ({"fov": 300}, r"^fov: must be 0.1 to 170"),
        ({"fov": "wide"}, r"^fov"),
        ({"fov": float("nan")}, r"^fov must be finite"),
        ({"size": 64}, r"^size must be two whole numbers"),
        ({"size": (0, 64)}, r"size"),
        ({"eye": (1, 2)}, r"^eye must be 3 numbers"),
        ({"tone_map": "agxx"}, r"did you mean 'agx'"),
        ({"technique": "separabel"}, r"did you mean 'separable'"),
        ({"technique": dermis}, r"^technique cannot be module"),
        ({"light": [(1,)]}, r"^light must be a list of"),
        ({"heads": None}, r"^heads cannot be None"),
        ({"environment": "nowhere.hdr"}, r"nowhere.hdr"),
    ],
)
def test_a_wrong_value_names_its_keyword(scene: dermis.Scene, keywords: dict[str, Any], message: str) -> None:
    with pytest.raises(dermis.InputError, match=message) as error:
        dermis.render(scene, **{**small, **keywords})
    assert "\n" not in str(error.value)


def test_errors_have_their_bases() -> None:
    assert issubclass(dermis.InputError, ValueError)
    assert issubclass(dermis.DeviceError, RuntimeError)
    assert dermis.Cancelled.__module__ == "dermis"
    with pytest.raises(dermis.DeviceError, match="no such"):
        dermis.Renderer("no such device")
    with pytest.raises(dermis.InputError, match="nowhere.glb"):
        dermis.Asset.load("nowhere.glb")
    with pytest.raises(dermis.InputError, match="did you mean 'light'"):
        dermis.Asset.load("built-in:lihgt")


def swapped(a: np.ndarray[Any, Any]) -> Any:
    return a.astype(a.dtype.newbyteorder(">"))


def strided(a: np.ndarray[Any, Any]) -> Any:
    return np.repeat(a, 2, axis=0)[::2]


@pytest.mark.parametrize(
    "other",
    [np.float64, np.float16, swapped, strided, np.asfortranarray, list],
)
def test_arrays_of_any_type_stride_and_byte_order_are_taken(other: Any) -> None:
    mesh = square()
    rounded = np.asarray(mesh.positions, np.float16).astype(np.float32)  # exact in each type
    mesh.positions = rounded
    wanted = dermis.Scene(dermis.Asset.from_arrays([mesh])).instances[0].positions_m(np.arange(9))
    mesh.positions = (
        rounded.astype(other) if isinstance(other, type) and other is not list else other(rounded)
    )
    mesh.indices = np.asarray(mesh.indices, ">i8")
    found = dermis.Scene(dermis.Asset.from_arrays([mesh])).instances[0].positions_m(np.arange(9))
    assert np.array_equal(wanted, found)


@pytest.mark.parametrize(
    "member, value, message",
    [
        ("positions", np.zeros((4, 2)), r"meshes\[0\].positions must have the shape \(N, 3\), got \(4, 2\)"),
        ("positions", np.zeros((4, 3), complex), r"must be real numbers, got complex128"),
        ("positions", np.full((4, 3), np.nan), r"must be finite: \[0, 0\] is not"),
        ("positions", np.full((4, 3), 1e300), r"must fit float32"),
        ("positions", [["a", "b", "c"]], r"must be numbers"),
        ("positions", [[1, 2, 3], [4, 5]], r"positions"),
        ("indices", [0.5, 1, 2], r"indices must be whole numbers, got float64"),
        ("indices", [-1, 1, 2], r"indices must be 0 to"),
        ("indices", [0, 1, 400], r"400"),
        ("uv", np.zeros((3, 2)), r"uv must have the shape \(81, 2\), got \(3, 2\)"),
        ("normals", np.zeros((81, 4)), r"normals must have the shape \(81, 3\)"),
        ("material", 3, r"material must be below"),
    ],
)
def test_arrays_that_are_wrong_are_refused(member: str, value: Any, message: str) -> None:
    mesh = square()
    setattr(mesh, member, value)
    with pytest.raises(dermis.InputError, match=message):
        dermis.Asset.from_arrays([mesh])


def test_maps_and_surroundings_are_checked(scene: dermis.Scene) -> None:
    wrong_maps: list[tuple[Any, str]] = [
        (np.zeros((4, 4, 3)), "must be uint8"),
        (np.zeros((4, 4, 5), np.uint8), "1 to 4"),
    ]
    for value, message in wrong_maps:
        with pytest.raises(dermis.InputError, match=message):
            dermis.Asset.from_arrays([square()], [dermis.Material(base_colour_map=value)])
    for value, message in [
        (np.zeros((4, 8)), r"\(H, W, 3\)"),
        (np.full((4, 8, 3), -1.0), "at least 0"),
        (np.full((4, 8, 3), np.inf), "must be finite"),
    ]:
        with pytest.raises(dermis.InputError, match=message):
            scene.set_environment(value)
    sky = np.zeros((8, 16, 3))
    sky[:4] = 1
    scene.set_environment(np.asfortranarray(sky))


def test_edits_that_are_wrong_change_nothing(scene: dermis.Scene) -> None:
    instance = scene.instances[0]
    before = instance.transform
    for wrong in (np.eye(3), np.diag([1, 2, 1, 1]), np.full((4, 4), np.nan), np.eye(4) * 1j):
        with pytest.raises(dermis.InputError):
            instance.transform = wrong
    assert np.array_equal(instance.transform, before)
    with pytest.raises(dermis.InputError, match="no vertex"):
        instance.positions_m([10**7])
    with pytest.raises(dermis.InputError):
        instance.pose(dermis.Pose(weights={"no such weight": 1}))
    with pytest.raises(dermis.InputError, match="did you mean 'point'"):
        scene.add_light(dermis.Light("poit"))  # type: ignore[arg-type]
    with pytest.raises(dermis.InputError):
        scene.set_lights([dermis.Light(), dermis.Light(colour=(-1, 0, 0))])
    assert len(scene.lights) == len(dermis.Scene(instance.asset).lights)
