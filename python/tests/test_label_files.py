# SPDX-License-Identifier: MIT
"""What `dermis render --labels` writes is what a session gives."""

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import small

import dermis

options = ["--size", "64x48", "--map-size", "256", "--shadow-size", "256", "--exposure", "0"]
names: Any = (
    "instance",
    "material",
    "depth",
    "normal",
    "uv",
    "region",
    "skin_mesh",
    "unwrap",
    "thickness",
    "matte",
    "part",
    "front",
    "front_part",
)


def render(program: Path, *arguments: Any) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [program, "render", "built-in", *options, *arguments], capture_output=True, text=True
    )


def test_layers_are_those_of_a_session(program: Path, scene: dermis.Scene, tmp_path: Path) -> None:
    exr = pytest.importorskip("OpenEXR")
    out = tmp_path / "face.exr"
    assert render(program, "--labels", "all", "-o", out).returncode == 0
    channels = exr.File(str(out), separate_channels=True).channels()
    frame = dermis.Session((*names, "linear")).draw(scene, **small)
    sheet = json.loads((tmp_path / "face.json").read_text())
    assert list(sheet["labels"]) == list(names)
    for name in names:
        wanted = frame.array(name).reshape(48, 64, -1)
        layers = sheet["labels"][name]["channels"]
        assert len(layers) == wanted.shape[2]
        for i, layer in enumerate(layers):
            assert np.array_equal(channels[layer].pixels, wanted[:, :, i]), layer
    for i, channel in enumerate("RGBA"):
        assert np.array_equal(channels[channel].pixels, frame.linear[:, :, i])
    assert sheet["labels"]["depth"]["unit"] == "m" and sheet["labels"]["depth"]["nothing"] == "infinity"
    assert sheet["instances"][0]["materials"] == scene.instances[0].asset.materials


def test_pngs_are_those_of_a_session(program: Path, scene: dermis.Scene, tmp_path: Path) -> None:
    image = pytest.importorskip("PIL.Image")
    out = tmp_path / "face.png"
    assert render(program, "--labels", "depth,region,material,thickness,normal", "-o", out).returncode == 0
    frame = dermis.Session(names).draw(scene, **small)
    sheet = json.loads((tmp_path / "face.json").read_text())
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(
        ["face.png", "face.json", *(label["file"] for label in sheet["labels"].values())]
    )
    there = np.isfinite(frame.depth)
    for name in ("depth", "region", "material", "thickness"):
        label = sheet["labels"][name]
        values = np.asarray(image.open(tmp_path / label["file"])).astype(np.float64)
        wanted = frame.array(name).astype(np.float64)
        assert (values[~there] == 0).all()
        off = np.abs(values * label["step"] + label["offset"] - wanted)[there]
        assert off.max() <= label["step"] / 2 + 1e-9, name

    # 8 of the 16 bits, which is what Pillow reads of colours.
    label = sheet["labels"]["normal"]
    values = np.asarray(image.open(tmp_path / label["file"])).astype(np.float64) * 257
    assert np.abs(values * label["step"] + label["offset"] - frame.normal)[there].max() < 1 / 100


def test_the_sheet_has_the_camera(program: Path, scene: dermis.Scene, tmp_path: Path) -> None:
    out = tmp_path / "face.png"
    assert render(program, "--labels", "depth", "--orbit", "20,5", "-o", out).returncode == 0
    sheet = json.loads((tmp_path / "face.json").read_text())["camera"]
    camera = scene.camera(**small, orbit=(20, 5))
    assert np.array_equal(sheet["K"], camera.K) and np.array_equal(sheet["R"], camera.R)
    assert np.array_equal(sheet["t_m"], camera.t) and sheet["width"] == 64


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["--labels", "dept", "-o", "x.png"], "did you mean 'depth'?"),
        (["--labels", "uv", "-o", "x.png"], "which no PNG holds"),
        (["--labels", "depth", "-o", "x.png", "--distance", "100"], "over the 6.5535 that a PNG holds"),
        (["--labels", "depth", "-o", "x.png", "--show", "stretch"], "output.show"),
        (["--labels", "depth", "-o", "x.png", "--stats", "x.json"], "--stats needs a file of its own"),
    ],
)
def test_what_cannot_be_written_is_refused(
    program: Path, tmp_path: Path, arguments: list[str], message: str
) -> None:
    arguments = [str(tmp_path / a) if a.startswith("x.") else a for a in arguments]
    result = render(program, *arguments)
    assert result.returncode == 1 and message in result.stderr, result.stderr
    assert result.stderr.count("\n") == 1 and not list(tmp_path.iterdir())
