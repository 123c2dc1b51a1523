# SPDX-License-Identifier: MIT
"""What python/README.md and python/datasets.md show are the files of python/examples, and they run."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import dermis

root = Path(__file__).parent.parent
examples = sorted((root / "examples").glob("*.py"))


@pytest.mark.parametrize("example", examples, ids=lambda path: str(path.stem))
def test_the_documents_show_it(example: Path) -> None:
    licence, _, code = example.read_text().partition("\n")
    assert licence.startswith("# SPDX-")
    documents = [(root / name).read_text() for name in ("README.md", "datasets.md")]
    assert any(f"```python\n{code}```" in text for text in documents)


def run(name: str, folder: Path) -> str:
    return subprocess.run(
        [sys.executable, root / "examples" / name], cwd=folder, check=True, capture_output=True, text=True
    ).stdout


def test_the_first_picture_is_drawn(tmp_path: Path) -> None:
    assert run("first_picture.py", tmp_path).splitlines() == [
        "(512, 512, 4) uint8",
        "(512, 512, 4) float32",
    ]
    assert (tmp_path / "head.png").stat().st_size > 50_000


def test_samples_are_labelled(tmp_path: Path) -> None:
    run("labelled_samples.py", tmp_path)
    for number in range(10):
        sample = np.load(tmp_path / f"sample-{number}.npz")
        head = np.isfinite(sample["depth"])
        assert 0.2 < head.mean() < 0.9
        assert (sample["region"] == 1).sum() > 50, "a nose"
        assert np.allclose(np.linalg.norm(sample["normal"][head], axis=-1), 1, atol=1e-5)
        y, x = np.nonzero(head)
        assert (sample["normal"][y, x, 2] < 0.3).mean() > 0.99, "towards the camera"
        points = np.column_stack([x, y, np.ones(len(x))]) @ np.linalg.inv(sample["K"]).T
        points = (points * sample["depth"][y, x, None] - sample["t"]) @ sample["R"]
        bounds = dermis.Asset.load("built-in").bounds
        assert np.linalg.norm(points - bounds.centre_m, axis=-1).max() < 3 * bounds.radius_m


def test_techniques_are_compared(tmp_path: Path) -> None:
    rows = [line.split() for line in run("error_table.py", tmp_path).splitlines()]
    skin = {row[0]: float(row[2]) for row in rows if row[1] == "skin"}
    assert set(skin) == {"texture-space", "separable", "lambert"}
    assert skin["texture-space"] < skin["lambert"]
