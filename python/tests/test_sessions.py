# SPDX-License-Identifier: MIT
"""Frames of sessions: what is asked for, in memory on lease."""

import gc
import resource
from typing import Any

import numpy as np
import pytest
from conftest import skin_of, small, square

import dermis

plain: dict[str, Any] = {
    "size": (32, 24),
    "map_size": 64,
    "shadow_size": 64,
    "exposure": 0.0,
    "technique": "lambert",
}


def test_frames_are_equal_to_pictures_to_the_bit(scene: dermis.Scene, renderer: dermis.Renderer) -> None:
    session = renderer.session()
    frame = session.draw(scene, **small)
    picture = renderer.render(scene, **small)
    assert np.array_equal(frame.display, picture.display)
    assert np.array_equal(frame.linear, picture.linear)


def test_give_what_is_wanted_and_nothing_else(scene: dermis.Scene, renderer: dermis.Renderer) -> None:
    types: dict[Any, Any] = {
        "display": (np.uint8, 4),
        "linear": (np.float32, 4),
        "instance": (np.uint32, 1),
        "material": (np.uint32, 1),
        "depth": (np.float32, 1),
        "normal": (np.float32, 3),
        "uv": (np.float32, 2),
        "motion": (np.float32, 2),
        "region": (np.uint8, 1),
        "skin_mesh": (np.uint32, 1),
        "unwrap": (np.float32, 2),
        "thickness": (np.float32, 1),
        "matte": (np.float32, 1),
    }
    frame = renderer.session(types).draw(scene, **plain)
    for name, (dtype, channels) in types.items():
        array = getattr(frame, name)
        assert array.dtype == dtype, name
        assert array.shape == ((24, 32) if channels == 1 else (24, 32, channels)), name
        one = renderer.session(name).draw(scene, **plain)
        assert np.array_equal(one.array(name), array), name
        assert one.bytes_read_back == array.nbytes, name
        other = "depth" if name != "depth" else "normal"
        with pytest.raises(dermis.InputError, match=f"does not draw '{other}'"):
            getattr(one, other)


def test_an_unknown_output_names_the_nearest(renderer: dermis.Renderer) -> None:
    with pytest.raises(dermis.InputError, match="did you mean 'depth'"):
        renderer.session("depht")  # type: ignore[arg-type]


def test_arrays_are_leased(renderer: dermis.Renderer) -> None:
    scene = dermis.Scene(skin_of(square()))
    session = renderer.session("depth", frames_in_flight=1)
    held, copies = [], []
    for i in range(5):
        scene.instances[0].transform = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.01 * i], [0, 0, 0, 1]]
        held.append(session.draw(scene, **plain, eye=(0, 0, 1), target=(0, 0, 0)).depth)
        copies.append(held[-1].copy())
    for i, (array, copy) in enumerate(zip(held, copies)):
        assert np.array_equal(array, copy)
        assert abs(array[12, 16] - (1 - 0.01 * i)) < 1e-6


def test_arrays_outlive_session_and_renderer() -> None:
    scene = dermis.Scene(skin_of(square()))
    with dermis.Renderer() as renderer:
        array = renderer.session("depth").draw(scene, **plain).depth
    copy = array.copy()
    gc.collect()
    array[0, 0] = 42
    assert np.array_equal(array[1:], copy[1:])


def test_writing_shows_in_the_memory(renderer: dermis.Renderer) -> None:
    frame = renderer.session("depth").draw(dermis.Scene(skin_of(square())), **plain)
    frame.depth[2, 3] = 7
    assert frame.depth[2, 3] == 7
    assert np.shares_memory(frame.depth, frame.depth)
    assert np.from_dlpack(frame.depth)[2, 3] == 7


def test_a_frame_that_is_gone_says_so(renderer: dermis.Renderer) -> None:
    scene = dermis.Scene(skin_of(square()))
    session = renderer.session("depth", frames_in_flight=1)
    first = session.draw(scene, **plain)
    session.draw(scene, **plain)
    with pytest.raises(dermis.InputError, match="ticket 1 is not of the last 1 frames"):
        first.wait()


def test_an_automatic_exposure_is_refused(scene: dermis.Scene, renderer: dermis.Renderer) -> None:
    with pytest.raises(dermis.InputError, match="automatic exposure needs frames of its own"):
        renderer.session().draw(scene, size=(32, 24), exposure=None)


@pytest.mark.parametrize("frames", [1500, pytest.param(10_000, marks=pytest.mark.long)])
def test_memory_is_flat(renderer: dermis.Renderer, frames: int) -> None:
    scene = dermis.Scene(skin_of(square()))
    session = renderer.session(("display", "depth", "normal"))

    def draw(count: int) -> float:
        for i in range(count):
            scene.instances[0].transform = [
                [1, 0, 0, 0],
                [0, 1, 0, 0],
                [0, 0, 1, 1e-4 * (i % 7)],
                [0, 0, 0, 1],
            ]
            session.draw(scene, **{**plain, "size": (64, 64)}).depth.sum()
        gc.collect()
        return float(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)

    before = draw(300)
    assert draw(frames) < before + 4096, "kB"
