# SPDX-License-Identifier: MIT
"""Parts of a face, the blended layer before it, and tables to the classes of data sets."""

from typing import Any

import numpy as np
import pytest
from conftest import skin_of, square

import dermis

view: dict[str, Any] = {
    "size": (320, 320),
    "map_size": 64,
    "shadow_size": 64,
    "exposure": 0.0,
    "technique": "lambert",
}
parts = dermis.part_names()
outputs: Any = ("depth", "part", "front", "front_part", "region", "material")


def number(name: str) -> int:
    return parts.index(name)


def test_lie_where_the_landmarks_say(scene: dermis.Scene, renderer: dermis.Renderer) -> None:
    instance = scene.instances[0]
    marks = dermis.Landmarks.of(instance.asset)
    assert marks is not None
    frame = renderer.session(outputs).draw(scene, **view)
    found = marks.in_picture(instance, scene.camera(**view), frame.depth)

    def part_at(*numbers: int, array: Any = frame.part) -> str:
        """In the middle of these points."""
        x, y = np.rint(found.pixels[list(numbers)].mean(axis=0)).astype(int)
        return parts[int(array[y, x])]

    assert [part_at(i) for i in (28, 29, 30, 33)] == ["nose"] * 4
    assert part_at(68) == "right eye" and part_at(69) == "left eye"
    assert part_at(51, 62) == "upper lip" and part_at(57, 66) == "lower lip"
    assert part_at(50, 61) == "upper lip" and part_at(58, 67) == "lower lip"
    assert part_at(31, 48) == "face" and part_at(19, 24) == "face" and part_at(8, 57) == "face"
    assert part_at(18, 19, array=frame.front_part) == "right brow"
    assert part_at(24, 25, array=frame.front_part) == "left brow"
    assert part_at(18, 19) == "face", "what lies behind"
    below = np.rint(found.pixels[8] + (0, 30)).astype(int)
    assert parts[frame.part[below[1], below[0]]] == "neck"

    # The person's left is on the right of a picture from the front.
    x = {name: np.nonzero(frame.part == number(name))[1].mean() for name in ("right ear", "left ear")}
    assert x["right ear"] < 110 and x["left ear"] > 210
    assert {parts[i] for i in np.unique(frame.part)} >= set(parts[:5] + parts[7:9])
    assert ((frame.part == 0) == np.isinf(frame.depth)).all()
    assert ((frame.part == number("nose")) == (frame.region == 1)).all()
    ears = (frame.part == number("right ear")) | (frame.part == number("left ear"))
    assert (ears == (frame.region == 2)).all()


def test_an_open_mouth_shows_its_interior(scene: dermis.Scene, renderer: dermis.Renderer) -> None:
    instance = scene.instances[0]
    instance.pose(dermis.Pose(weights={"jaw open": 1.0}))
    marks = dermis.Landmarks.of(instance.asset)
    assert marks is not None
    frame = renderer.session(outputs).draw(scene, **view)
    found = marks.in_picture(instance, scene.camera(**view), frame.depth)
    x, y = np.rint(found.pixels[[62, 66]].mean(axis=0)).astype(int)
    assert parts[frame.part[y, x]] == "mouth interior"
    upper, lower = np.rint(found.pixels[[51, 57]]).astype(int)
    column = frame.part[upper[1] + 1 : lower[1], upper[0]]
    names = [parts[i] for i in column]
    assert names[0] == "upper lip" and names[-1] == "lower lip", names


def test_the_layer_before_is_brows_and_lashes(scene: dermis.Scene, renderer: dermis.Renderer) -> None:
    frame = renderer.session((*outputs, "matte")).draw(scene, **view)
    shown = {parts[i] for i in np.unique(frame.front_part)}
    assert {"right brow", "left brow"} <= shown <= {
        "nothing", "right brow", "left brow", "lashes", "right eye", "left eye"
    }  # fmt: skip
    assert frame.front.min() == 0 and 0.5 < frame.front.max() <= 1
    assert (frame.front[frame.front_part > 0] >= 0.5 - 1e-3).all()
    assert (frame.front > 0).mean() < 0.1
    # Of the built-in head all hair lies before its skin.
    assert (frame.matte[frame.front > 0.1] > 0.99).all()


def test_without_landmarks_skin_is_a_face(renderer: dermis.Renderer) -> None:
    frame = renderer.session(("part", "front", "front_part")).draw(dermis.Scene(skin_of(square())), **view)
    assert np.unique(frame.part).tolist() == [0, 1]
    assert not frame.front.any() and not frame.front_part.any()


def test_tables_to_the_classes_of_others() -> None:
    assert len(parts) == 16 and parts[0] == "nothing"
    theirs = dermis.part_classes("FaceSynthetics")
    assert theirs.dtype == np.uint8
    assert theirs[: number("hair") + 1].tolist() == list(range(14)), "our numbers are those of its README"
    assert theirs[number("lashes")] == 255
    celeba = dermis.part_classes("CelebAMask-HQ")
    # Order of the label list in its README.
    names = "background skin nose eye_g l_eye r_eye l_brow r_brow l_ear r_ear mouth u_lip l_lip hair hat"
    classes = [*names.split(), "ear_r", "neck_l", "neck", "cloth"]
    by_name = {part: classes[number] for part, number in zip(parts, celeba, strict=True)}
    assert by_name["left eye"] == "l_eye" and by_name["right brow"] == "r_brow"
    assert by_name["lower lip"] == "l_lip" and by_name["neck"] == "neck" and by_name["face"] == "skin"
    assert by_name["mouth interior"] == "mouth" and by_name["other"] == "background"
    with pytest.raises(dermis.InputError, match="CelebAMask-HQ"):
        dermis.part_classes("CelebAMask")  # type: ignore[arg-type]
