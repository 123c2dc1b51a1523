# SPDX-License-Identifier: MIT
"""The notebook runs from its first cell to its last, and what it says holds."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

notebook = Path(__file__).parent.parent / "examples" / "tutorial.ipynb"


def cells() -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = json.loads(notebook.read_text())["cells"]
    return found


def test_is_stored_without_outputs() -> None:
    for cell in cells():
        assert not cell.get("outputs") and cell.get("execution_count") is None


@pytest.mark.long
def test_the_tutorial_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    matplotlib: Any = pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {"__name__": "tutorial"}
    for number, cell in enumerate(cells()):
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), f"cell {number}", "exec"), names)

    table = names["table"]
    error = {name: table.row(name).relative_mse_less_noise for name in names["names"]}
    assert error["texture-space"] < error["lambert"], "scattering brings it nearer"
    assert all(len(values) == 3 and min(values) > 0 for values in names["errors"].values())
    blender = json.loads((tmp_path / "skin-for-blender.json").read_text())
    assert {"Color", "Radius", "Scale"} <= set(blender["parameters"])
    for number in range(10):
        sample = np.load(tmp_path / f"sample-{number}.npz")
        assert (sample["region"] == 1).any() and np.isfinite(sample["depth"]).mean() > 0.2
