# SPDX-License-Identifier: MIT
"""Data sets: equal however they are drawn, by this module, by the command line, by Dask."""

import base64
import hashlib
import json
import subprocess
import tarfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dermis
import dermis.dataset


def square() -> str:
    """glTF of a square of skin of 0.2 m, which faces +z."""
    corners = np.array([[-0.1, -0.1, 0], [0.1, -0.1, 0], [0.1, 0.1, 0], [-0.1, 0.1, 0]], np.float32)
    uv = np.array([[0, 1], [1, 1], [1, 0], [0, 0]], np.float32)
    parts = [corners.tobytes(), uv.tobytes(), np.array([0, 1, 2, 0, 2, 3], np.uint32).tobytes()]
    starts = [0, len(parts[0]), len(parts[0]) + len(parts[1])]
    data = base64.b64encode(b"".join(parts)).decode()
    views = [{"buffer": 0, "byteOffset": s, "byteLength": len(p)} for s, p in zip(starts, parts, strict=True)]
    low, high = corners.min(0).tolist(), corners.max(0).tolist()
    accessors = [
        {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4, "min": low, "max": high},
        {"bufferView": 1, "componentType": 5126, "type": "VEC2", "count": 4},
        {"bufferView": 2, "componentType": 5125, "type": "SCALAR", "count": 6},
    ]
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}
    return json.dumps(
        {
            "asset": {"version": "2.0", "copyright": "A. Author, CC BY 4.0"},
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [primitive]}],
            "materials": [{"name": "skin"}],
            "accessors": accessors,
            "bufferViews": views,
            "buffers": [
                {"uri": "data:application/octet-stream;base64," + data, "byteLength": sum(map(len, parts))}
            ],
        }
    )


def recipe_in(folder: Path, **changes: Any) -> Path:
    recipe: dict[str, Any] = {
        "schema": 1,
        "name": "squares",
        "samples": 12,
        "samples_per_shard": 3,
        "size": [32, 24],
        "labels": ["depth", "uv", "instance"],
        "identities": [{"asset": "square.gltf"}],
        "settings": {
            "technique": "lambert",
            "quality": {"map_size": 64, "shadow_size": 64},
            "camera": {"orbit_deg": [{"uniform": [-40, 40]}, {"uniform": [-20, 20]}]},
            "output": {"exposure_ev": 0},
        },
    }
    (folder / "square.gltf").write_text(square())
    (folder / "recipe.json").write_text(json.dumps(recipe | changes))
    return folder / "recipe.json"


def hashes(folder: Path) -> dict[str, str]:
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.glob("*.tar")}


def test_is_prepared_drawn_and_verified(tmp_path: Path, program: Path) -> None:
    path = recipe_in(tmp_path)
    recipe = dermis.dataset.prepare(path, tmp_path / "set")
    assert (recipe.samples, recipe.shards, recipe.identities) == (12, 4, 1)
    assert recipe.parameters(7)["settings"] == dermis.dataset.Recipe(path).parameters(7)["settings"]
    assert dermis.dataset.missing(tmp_path / "set") == [0, 1, 2, 3]
    assert dermis.dataset.write(tmp_path / "set", []) == dermis.dataset.Written()
    assert dermis.dataset.write(tmp_path / "set", [2]) == dermis.dataset.Written(1, 3, 0, 0)
    assert dermis.dataset.write(tmp_path / "set").there == 1
    found = dermis.dataset.verify(tmp_path / "set", redraw=0.5)
    assert (found.faults, found.warnings, found.redrawn) == ([], [], 6)

    # The command line draws the same bytes.
    subprocess.run([program, "dataset", "prepare", path, "-o", tmp_path / "other"], check=True)
    subprocess.run([program, "dataset", "write", tmp_path / "other"], check=True)
    assert len(hashes(tmp_path / "set")) == 4
    assert hashes(tmp_path / "set") == hashes(tmp_path / "other")

    assert len(dermis.dataset.coco(tmp_path / "set")["images"]) == 12
    assert "settings.camera.orbit_deg[1]" in dermis.dataset.sheet(tmp_path / "set", samples=3)
    assert "| `settings.camera.orbit_deg` |" in dermis.dataset.datasheet(tmp_path / "set")
    assert "#SBATCH" in dermis.dataset.slurm(tmp_path / "set")


def test_files_are_those_of_other_programs(tmp_path: Path) -> None:
    """tarfile and NumPy read them; the values are those of a session."""
    Image = pytest.importorskip("PIL.Image")
    dermis.dataset.prepare(recipe_in(tmp_path), tmp_path / "set")
    dermis.dataset.write(tmp_path / "set")
    with tarfile.open(tmp_path / "set" / "train-000001.tar") as tar:
        assert tar.getnames()[:3] == ["000003.png", "000003.json", "000003.instance.png"]
        assert all((m.mtime, m.uid, m.gid, m.uname, m.mode) == (0, 0, 0, "", 0o644) for m in tar)
        tar.extractall(tmp_path / "out")
    sample = json.loads((tmp_path / "out" / "000003.json").read_text())
    scene = dermis.Scene.load(tmp_path / "square.gltf")
    session = dermis.Session(outputs=("display", "depth", "uv"))
    frame = session.draw(
        scene,
        technique="lambert",
        map_size=64,
        shadow_size=64,
        orbit=sample["settings"]["camera"]["orbit_deg"],
        exposure=0,
        size=(32, 24),
    )
    assert np.array_equal(np.asarray(Image.open(tmp_path / "out" / "000003.png")), frame.display[..., :3])
    assert np.array_equal(np.load(tmp_path / "out" / "000003.uv.npy"), frame.uv)
    label = sample["labels"]["depth"]
    depth = np.asarray(Image.open(tmp_path / "out" / label["file"])).astype(float) * label["step"]
    seen = np.isfinite(frame.depth)
    assert seen.any() and np.abs(depth - frame.depth)[seen].max() <= 0.51 * label["step"]
    assert np.all(depth[~seen] == label["nothing"])


def test_mistakes_are_named(tmp_path: Path) -> None:
    with pytest.raises(dermis.InputError, match="no prepared data set"):
        dermis.dataset.write(tmp_path)
    with pytest.raises(dermis.InputError, match="sampels"):
        dermis.dataset.Recipe(recipe_in(tmp_path, sampels=3))
    with pytest.raises(dermis.InputError, match="none.gltf: no such file"):
        dermis.dataset.prepare(recipe_in(tmp_path, identities=[{"asset": "none.gltf"}]), tmp_path / "set")
    dermis.dataset.prepare(recipe_in(tmp_path), tmp_path / "set")
    with pytest.raises(dermis.InputError, match="no shard 4"):
        dermis.dataset.write(tmp_path / "set", [4])


def test_a_progress_function_ends_the_work(tmp_path: Path) -> None:
    dermis.dataset.prepare(recipe_in(tmp_path), tmp_path / "set")
    with pytest.raises(dermis.dataset.TryAgain, match="stopped in shard 2"):
        dermis.dataset.write(tmp_path / "set", progress=lambda what, share: what != "train-000002.tar")
    assert dermis.dataset.missing(tmp_path / "set") == [2, 3]


def test_dask_draws_the_same(tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed", reason="apt-get install python3-distributed")
    path = recipe_in(tmp_path, samples=200, samples_per_shard=10, size=[96, 96])
    for name in ("alone", "dask"):
        dermis.dataset.prepare(path, tmp_path / name)
    dermis.dataset.write(tmp_path / "alone")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        written = dermis.dataset.dask(tmp_path / "dask", client)
    assert (written.shards, written.samples) == (20, 200)
    assert len(hashes(tmp_path / "alone")) == 20
    assert hashes(tmp_path / "alone") == hashes(tmp_path / "dask")
