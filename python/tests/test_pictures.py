# SPDX-License-Identifier: MIT
"""Pictures are those of the command line, and arrays are the memory of their objects."""

import gc
import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import small

import dermis


@pytest.mark.parametrize("technique", ["texture-space", "lambert", "separable"])
@pytest.mark.parametrize("ending", [".png", ".exr"])
def test_are_equal_to_the_command_line_to_the_bit(
    program: Path, scene: dermis.Scene, renderer: dermis.Renderer, tmp_path: Path, technique: str, ending: str
) -> None:
    wanted, found = tmp_path / f"wanted{ending}", tmp_path / f"found{ending}"
    subprocess.run(
        [
            program,
            "render",
            "built-in",
            "-o",
            wanted,
            "--size",
            "64x48",
            "--map-size",
            "256",
            "--shadow-size",
            "256",
            "--exposure",
            "0.5",
            "--technique",
            technique,
            "--orbit",
            "30,5",
            "--light",
            "40,20,2",
        ],
        check=True,
        capture_output=True,
    )
    renderer.render(
        scene,
        size=(64, 48),
        map_size=256,
        shadow_size=256,
        exposure=0.5,
        technique=technique,
        orbit=(30, 5),
        light=[(40, 20, 2)],
    ).save(found)
    assert wanted.read_bytes() == found.read_bytes()


def test_have_shapes_and_types(scene: dermis.Scene, renderer: dermis.Renderer) -> None:
    picture = renderer.render(scene, **small)
    assert (picture.width, picture.height) == (64, 48)
    assert picture.display.shape == (48, 64, 4) and picture.display.dtype == np.uint8
    assert picture.linear.shape == (48, 64, 4) and picture.linear.dtype == np.float32
    assert picture.display.flags.c_contiguous and picture.display.flags.writeable
    assert (picture.display[:, :, 3] == 255).all()
    assert 0.1 < picture.linear[:, :, 3].mean() < 0.9, "some of it is skin"
    assert picture.statistics["settings"]["output"]["width"] == 64


def test_arrays_are_the_memory(scene: dermis.Scene, renderer: dermis.Renderer) -> None:
    picture = renderer.render(scene, **small)
    picture.linear[3, 4] = (1, 2, 3, 4)
    assert picture.linear[3, 4].tolist() == [1, 2, 3, 4]
    assert np.from_dlpack(picture.linear)[3, 4].tolist() == [1, 2, 3, 4]
    view = memoryview(picture.display)  # type: ignore[arg-type]
    view[0, 0, 0] = 42
    assert picture.display[0, 0, 0] == 42


def test_arrays_outlive_their_picture(scene: dermis.Scene, renderer: dermis.Renderer) -> None:
    picture = renderer.render(scene, **small)
    array, copy = picture.linear, picture.linear.copy()
    del picture
    gc.collect()
    for _ in range(3):
        renderer.render(scene, **small)
    assert np.array_equal(array, copy)


def test_save_refuses_other_endings(scene: dermis.Scene, renderer: dermis.Renderer, tmp_path: Path) -> None:
    with pytest.raises(dermis.InputError, match="gif"):
        renderer.render(scene, **small).save(tmp_path / "x.gif")


def test_png_of_notebooks_is_the_picture(
    scene: dermis.Scene, renderer: dermis.Renderer, tmp_path: Path
) -> None:
    image = pytest.importorskip("PIL.Image")
    picture = renderer.render(scene, **small)
    file = tmp_path / "x.png"
    file.write_bytes(picture._repr_png_())
    assert np.array_equal(np.asarray(image.open(file)), picture.display)


def test_of_an_asset_a_scene_and_a_name_are_one(head: dermis.Asset) -> None:
    a = dermis.render(dermis.Scene(head), **small).display
    assert np.array_equal(a, dermis.render(head, **small).display)
    assert np.array_equal(a, dermis.render("built-in", **small).display)


def test_keywords_take_what_numpy_has(scene: dermis.Scene, renderer: dermis.Renderer) -> None:
    a = renderer.render(scene, **small, fov=30.0, eye=(0.2, 0.1, 0.8), target=(0, 0, 0), translucency=False)
    b = renderer.render(
        scene,
        size=np.array([64, 48]),
        map_size=np.int64(256),
        shadow_size=np.uint16(256),
        exposure=np.float32(0),
        fov=np.float64(30),
        eye=np.array([0.2, 0.1, 0.8]),
        target=[0, 0, 0],
        translucency="off",
    )
    assert np.array_equal(a.linear, b.linear)
    c = renderer.render(scene, **small, light=[{"azimuth_deg": 30, "elevation_deg": 10}])
    d = renderer.render(scene, **small, light=[(30, 10)])
    assert np.array_equal(c.linear, d.linear)


def test_instances_profiles_and_lights_change_the_picture(
    head: dermis.Asset, renderer: dermis.Renderer
) -> None:
    scene = dermis.Scene(head)
    instance = scene.instances[0]
    before = renderer.render(scene, **small).linear
    instance.tint = (0.5, 0.4, 0.3)
    tinted = renderer.render(scene, **small).linear
    assert tinted.mean() < before.mean()
    instance.tint = (1, 1, 1)
    instance.profile = dermis.Profile.preset("skin2")
    assert not np.array_equal(renderer.render(scene, **small).linear, before)
    instance.profile = None
    assert np.array_equal(renderer.render(scene, **small).linear, before)
    scene.set_lights([dermis.Light("directional", colour=(2, 2, 2), direction=(0, -0.3, -1))])
    assert not np.array_equal(renderer.render(scene, **small).linear, before)
    assert scene.lights[0].colour == (2, 2, 2)
    instance.transform = [[0.5, 0, 0, 0.1], [0, 0.5, 0, 0], [0, 0, 0.5, 0], [0, 0, 0, 1]]
    assert instance.transform[0, 3] == 0.1
