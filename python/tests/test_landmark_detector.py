# SPDX-License-Identifier: MIT
"""The detector of python/datasets.md learns: of people whom it has not seen, it beats the mean shape."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

import dermis.dataset

examples = Path(__file__).parent.parent / "examples"


def interpreter() -> str:
    """A Python that has torch: this one, or the system's, which has it from python3-torch."""
    for python in (sys.executable, "/usr/bin/python3"):
        found = subprocess.run([python, "-c", "import numpy, PIL.Image, torch"], capture_output=True)
        if found.returncode == 0:
            return python
    pytest.skip("no Python here has torch and Pillow: apt-get install python3-torch python3-pil")


@pytest.mark.long
def test_the_detector_beats_the_mean_shape(tmp_path: Path) -> None:
    python = interpreter()
    recipe = json.loads((examples / "landmarks.json").read_text())
    (tmp_path / "recipe.json").write_text(json.dumps(recipe | {"samples": 240, "samples_per_shard": 80}))
    dermis.dataset.prepare(tmp_path / "recipe.json", tmp_path / "faces")
    dermis.dataset.write(tmp_path / "faces")
    told = subprocess.run(
        [python, examples / "landmark_detector.py", tmp_path / "faces", "--epochs", "40"],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    known, others, mean_shape = (float(px) for px in re.findall(r": ([0-9.]+) px", told))
    assert known < 0.5 * mean_shape, told
    assert others < 0.7 * mean_shape, told
