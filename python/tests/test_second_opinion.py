# SPDX-License-Identifier: MIT
"""Mitsuba 3, where it is installed, makes the reference's picture of a ball of skin."""

import importlib.util
import json
import subprocess
import sys
from pathlib import Path

import pytest

script = Path(__file__).parent.parent.parent / "bench" / "mitsuba" / "second_opinion.py"


@pytest.mark.long
def test_mitsuba_agrees_on_a_ball(tmp_path: Path) -> None:
    if importlib.util.find_spec("mitsuba") is None:
        pytest.skip("mitsuba is not installed")
    out = tmp_path / "out.json"
    command: list[str | Path] = [sys.executable, script, out, "--case", "ball", "--samples", "40"]
    subprocess.run(command, check=True, timeout=900)
    skin = json.loads(out.read_text())["cases"][0]["regions"]["skin"]
    assert skin["pixels"] > 1000
    for ratio, error in zip(skin["mitsuba_over_ours"], skin["standard_error"]):
        assert error < 0.03 and abs(ratio - 1) < 4 * error
    assert skin["rel_mse_less_noise"] < 0.1 * skin["rel_mse"]
