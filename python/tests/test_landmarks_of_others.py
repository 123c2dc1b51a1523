# SPDX-License-Identifier: MIT
"""Landmarks of heads of others; of ICT-FaceKit against vertices that NumPy reads from its file and morphs.
Skipped where a file is not at hand: $DERMIS_ASSET_CACHE names the folder."""

import json
import os
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import dermis

cache = Path(os.environ.get("DERMIS_ASSET_CACHE", ""))
heads = Path(__file__).parent.parent.parent / "assets" / "heads"
file = cache / "ict-facekit" / "ict-mean-animated.glb"
view: dict[str, Any] = {
    "size": (300, 300),
    "map_size": 64,
    "shadow_size": 64,
    "exposure": 0.0,
    "technique": "lambert",
}
types = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}


class Glb:
    """What glTF 2.0 says of accessors, sparse ones included, and no more."""

    def __init__(self, path: Path) -> None:
        data = path.read_bytes()
        length = struct.unpack("<I", data[12:16])[0]
        self.json: dict[str, Any] = json.loads(data[20 : 20 + length])
        self.bytes = data[28 + length :]

    def _values(self, view: dict[str, Any], kind: int, count: int, columns: int) -> NDArray[Any]:
        of_view = self.json["bufferViews"][view["bufferView"]]
        first = of_view.get("byteOffset", 0) + view.get("byteOffset", 0)
        return np.frombuffer(self.bytes, types[kind], count * columns, first).reshape(count, columns)

    def positions(self, number: int) -> NDArray[np.float64]:
        accessor = self.json["accessors"][number]
        values = np.zeros((accessor["count"], 3))
        if "bufferView" in accessor:
            values[:] = self._values(accessor, accessor["componentType"], accessor["count"], 3)
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            at = self._values(sparse["indices"], sparse["indices"]["componentType"], sparse["count"], 1)
            values[at[:, 0]] = self._values(sparse["values"], 5126, sparse["count"], 3)
        return values

    def morphed(self, weights: dict[str, float]) -> list[NDArray[np.float64]]:
        """The vertices of each primitive."""
        mesh = self.json["meshes"][0]
        names = mesh["extras"]["targetNames"]
        primitives = []
        for primitive in mesh["primitives"]:
            points = self.positions(primitive["attributes"]["POSITION"])
            for name, weight in weights.items():
                points = points + weight * self.positions(primitive["targets"][names.index(name)]["POSITION"])
            primitives.append(points)
        return primitives


@pytest.mark.skipif(not file.is_file(), reason=f"{file} is not there")
def test_follow_morph_targets_of_the_file(renderer: dermis.Renderer) -> None:
    asset = dermis.Asset.load(file)
    marks = dermis.Landmarks.of(asset)
    assert marks is not None
    scene = dermis.Scene(asset)
    instance = scene.instances[0]
    c, s = np.cos(-0.4), np.sin(-0.4)
    instance.transform = [[c, 0, s, 0.01], [0, 1, 0, -0.2], [-s, 0, c, 0.02], [0, 0, 0, 1]]
    weights = {"jawOpen": 0.7, "mouthSmile_L": 0.5, "eyeBlink_R": 1.0, "browInnerUp_L": 0.4}
    instance.pose(dermis.Pose(weights=weights))
    seen_by: dict[str, Any] = {**view, "eye": (0.1, 0.05, 1.0), "target": (0.0, 0.0, 0.0)}
    camera = scene.camera(**seen_by)
    frame = renderer.session(("depth", "region")).draw(scene, **seen_by)
    found = marks.in_picture(instance, camera, frame.depth)

    primitives = Glb(file).morphed(weights)
    points = np.array(
        [np.array(place.weights) @ primitives[place.mesh][list(place.triangle)] for place in marks.places]
    )
    world = points @ instance.transform[:3, :3].T + instance.transform[:3, 3]
    in_camera = world @ camera.R.T + camera.t
    assert np.abs(found.pixels - ((in_camera / in_camera[:, 2:]) @ camera.K.T)[:, :2]).max() < 0.01
    assert np.abs(found.depth - in_camera[:, 2]).max() < 1e-5
    assert not found.seen[68] and found.seen[69], "the right eye is closed"

    x, y = np.rint(found.pixels[27:36]).astype(int).T
    assert (frame.region[y, x][found.seen[27:36]] == 1).all() and found.seen[27:36].sum() >= 6


@pytest.mark.parametrize(
    "path, open_mouth",
    [
        (file, "jawOpen"),
        (cache / "makehuman" / "mh-asian-woman-young.glb", "mouth-open"),
        (heads / "lee-perry-smith.gltf", None),
    ],
)
def test_lie_on_their_parts(path: Path, open_mouth: str | None, renderer: dermis.Renderer) -> None:
    if not path.is_file() or (path.parent == heads and not (heads / "LeePerrySmith.glb").is_file()):
        pytest.skip(f"{path} is not there, or lacks its mesh")
    asset = dermis.Asset.load(path)
    marks = dermis.Landmarks.of(asset)
    assert marks is not None
    scene = dermis.Scene(asset)
    instance = scene.instances[0]
    rest = marks.positions_m(instance)
    # From the front, however a camera of the file stands.
    middle = rest[[0, 16, 8]].mean(axis=0)
    seen_by = {**view, "eye": tuple(middle + (0, 0, 0.8)), "target": tuple(middle), "fov": 18.0}
    frame = renderer.session(("depth", "region", "part")).draw(scene, **seen_by)
    found = marks.in_picture(instance, scene.camera(**seen_by), frame.depth)
    x, y = np.rint(found.pixels).astype(int).T
    names = np.array(dermis.part_names())
    assert found.seen[27:34].all()
    assert (frame.region[y[27:36], x[27:36]][found.seen[27:36]] == 1).all()

    def part_between(*numbers: int) -> str:
        column, row = np.rint(found.pixels[list(numbers)].mean(axis=0)).astype(int)
        return str(names[frame.part[row, column]])

    assert part_between(51, 62) == "upper lip" and part_between(57, 66) == "lower lip"
    assert part_between(8, 57) == "face" and part_between(19) == "face"
    if open_mouth is None:
        return
    assert names[frame.part[y[[68, 69]], x[[68, 69]]]].tolist() == ["right eye", "left eye"]
    instance.pose(dermis.Pose(weights={open_mouth: 1.0}))
    opened = marks.positions_m(instance)
    gap = (opened - rest)[[61, 62, 63], 1] - (opened - rest)[[67, 66, 65], 1]
    assert gap.min() > 4e-3, "points of the lower lip part from those of the upper one"
