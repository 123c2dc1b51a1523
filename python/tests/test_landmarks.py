# SPDX-License-Identifier: MIT
"""Landmarks under poses and morphs, against vertices posed by NumPy, and in what the command line writes."""

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import skin_of, square
from numpy.typing import NDArray

import dermis

view: dict[str, Any] = {
    "size": (240, 240),
    "map_size": 64,
    "shadow_size": 64,
    "exposure": 0.0,
    "technique": "lambert",
}
nose = range(27, 36)


@pytest.fixture(scope="module")
def marks(head: dermis.Asset) -> dermis.Landmarks:
    found = dermis.Landmarks.of(head)
    assert found is not None
    return found


def posed_by_numpy(
    marks: dermis.Landmarks, head: dermis.Asset, weights: dict[str, float], transform: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Where the landmarks stand, from morph targets that are asked for one by one: a pose of weights moves
    each vertex by the sum of what its targets do alone, each in proportion to its weight."""
    places = marks.places
    at_rest = dermis.Scene(head).instances[0]

    def corners(instance: dermis.Instance) -> NDArray[np.float64]:
        return np.stack([instance.positions_m(place.triangle, mesh=place.mesh) for place in places])

    rest = corners(at_rest)
    points = rest.copy()
    for name, weight in weights.items():
        alone = dermis.Scene(head).instances[0]
        alone.pose(dermis.Pose(weights={name: 1.0}))
        points += weight * (corners(alone) - rest)
    of_asset = (points * np.array([place.weights for place in places])[:, :, None]).sum(axis=1)
    return np.asarray(of_asset @ transform[:3, :3].T + transform[:3, 3])


def test_follow_poses_and_morphs(
    marks: dermis.Landmarks, head: dermis.Asset, renderer: dermis.Renderer
) -> None:
    scene = dermis.Scene(head)
    instance = scene.instances[0]
    c, s = np.cos(0.3), np.sin(0.3)
    transform = 1.1 * np.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1 / 1.1]])
    transform[:3, 3] = (0.02, 0.01, -0.03)
    instance.transform = transform
    weights = {"jaw open": 0.6, "smile": 0.5, "blink left": 0.3, "brows up": 0.7}
    instance.pose(dermis.Pose(weights=weights))
    seen_by = {**view, "eye": (0.2, 0.05, 1.0), "target": (0.0, 0.0, 0.0)}
    camera = scene.camera(**seen_by)
    found = marks.in_picture(instance, camera, renderer.session("depth").draw(scene, **seen_by).depth)

    in_camera = posed_by_numpy(marks, head, weights, transform) @ camera.R.T + camera.t
    pixels = (in_camera / in_camera[:, 2:]) @ camera.K.T
    assert np.abs(found.pixels - pixels[:, :2]).max() < 0.01
    assert np.abs(found.depth - in_camera[:, 2]).max() < 1e-5
    moved = marks.positions_m(instance) - (
        marks.positions_m(dermis.Scene(head).instances[0]) @ transform[:3, :3].T + transform[:3, 3]
    )
    assert np.abs(moved).max() > 5e-3, "the pose moves something"


@pytest.mark.parametrize("turn", [0, 35])
def test_of_the_nose_lie_in_the_label_nose(
    marks: dermis.Landmarks, scene: dermis.Scene, renderer: dermis.Renderer, turn: int
) -> None:
    instance = scene.instances[0]
    instance.pose(dermis.Pose(weights={"smile": 0.5}))
    seen_by = {**view, "orbit": (turn, 0)}
    frame = renderer.session(("depth", "region", "material")).draw(scene, **seen_by)
    found = marks.in_picture(instance, scene.camera(**seen_by), frame.depth)
    x, y = np.rint(found.pixels).astype(int).T
    wrong = [number for number in nose if found.seen[number] and frame.region[y[number], x[number]] != 1]
    assert not wrong
    assert found.seen[list(nose)].sum() >= 6
    names = instance.asset.materials
    for pupil in (68, 69):
        if found.seen[pupil]:
            assert names[frame.material[y[pupil], x[pupil]] - 1] == "eye"


def test_seen_from_the_front_and_from_a_side(
    marks: dermis.Landmarks, scene: dermis.Scene, renderer: dermis.Renderer
) -> None:
    instance = scene.instances[0]
    session = renderer.session("depth")

    def seen(**more: Any) -> NDArray[np.bool_]:
        depth = session.draw(scene, **view, **more).depth
        return marks.in_picture(instance, scene.camera(**view, **more), depth).seen

    front = seen()
    assert front[27:31].all() and front[36:48].sum() >= 10 and front[[68, 69]].all()
    # Azimuth turns the camera towards the head's left.
    left = seen(orbit=(80, 0))
    assert left[[13, 14, 15, 25]].all() and not left[[1, 2, 3, 18, 36, 68]].any()
    right = seen(orbit=(-80, 0))
    assert right[[1, 2, 3, 18]].all() and not right[[13, 14, 15, 25, 45, 69]].any()
    assert not seen(orbit=(180, 0)).any()


def test_closed_lids_hide_the_pupils(
    marks: dermis.Landmarks, scene: dermis.Scene, renderer: dermis.Renderer
) -> None:
    instance = scene.instances[0]
    instance.pose(dermis.Pose(weights={"blink left": 1.0}))
    found = marks.in_picture(
        instance, scene.camera(**view), renderer.session("depth").draw(scene, **view).depth
    )
    assert found.seen[68] and not found.seen[69], "69 is the person's left"


def test_of_an_asset_of_ones_own(tmp_path: Path) -> None:
    asset = skin_of(square())
    assert dermis.Landmarks.of(asset) is None
    point = {"mesh": 0, "triangle": [0, 9, 1], "weights": [0.5, 0.25, 0.25]}
    sheet = {
        "schema": 1,
        "about": "a test",
        "meshes": [{"mesh": 0, "vertices": 81, "triangles": 128}],
        "points": [point] * 70,
    }
    file = tmp_path / "square.landmarks.json"
    file.write_text(json.dumps(sheet))
    marks = dermis.Landmarks.load(asset, file)
    instance = dermis.Scene(asset).instances[0]
    by_hand = np.array([0.5, 0.25, 0.25]) @ instance.positions_m([0, 9, 1])
    assert np.allclose(marks.positions_m(instance), by_hand, atol=1e-12)
    with pytest.raises(dermis.InputError, match="another asset"):
        marks.positions_m(dermis.Scene(skin_of(square(0.3))).instances[0])
    with pytest.raises(dermis.InputError, match="shape of the picture"):
        marks.in_picture(instance, dermis.Scene(asset).camera(**view), np.zeros((3, 4), np.float32))

    file.write_text(json.dumps({**sheet, "meshes": [{"mesh": 0, "vertices": 82, "triangles": 128}]}))
    with pytest.raises(dermis.InputError, match="81 vertices and 128 triangles") as caught:
        dermis.Landmarks.load(asset, file)
    assert "\n" not in str(caught.value)


def test_of_the_command_line_are_those_of_the_module(
    program: Path, marks: dermis.Landmarks, scene: dermis.Scene, renderer: dermis.Renderer, tmp_path: Path
) -> None:
    options = ["--size", "120x100", "--map-size", "64", "--shadow-size", "64", "--exposure", "0"]
    options += ["--technique", "lambert", "--orbit", "30,10"]
    command = [program, "render", "built-in", *options, "--labels", "landmarks", "-o", tmp_path / "face.png"]
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["face.json", "face.png"]
    sheet = json.loads((tmp_path / "face.json").read_text())
    points = np.array(sheet["landmarks"]["instances"][0])

    seen_by: dict[str, Any] = {**view, "size": (120, 100), "orbit": (30, 10)}
    depth = renderer.session("depth").draw(scene, **seen_by).depth
    found = marks.in_picture(scene.instances[0], scene.camera(**seen_by), depth)
    assert np.array_equal(points[:, :2], found.pixels) and np.array_equal(points[:, 2], found.depth)
    assert np.array_equal(points[:, 3] == 1, found.seen) and 20 < found.seen.sum() < 70
