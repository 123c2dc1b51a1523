# SPDX-License-Identifier: MIT
"""Profiles of colours, tables and other systems, and for other systems."""

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dermis
import dermis.profile


@pytest.fixture(scope="module")
def skin1() -> dermis.Profile:
    return dermis.Profile.preset("skin1", model="dipole")


def test_exports_are_those_of_the_program(skin1: dermis.Profile, program: Path) -> None:
    for system in dermis.profile.systems():
        said = subprocess.run(
            [program, "profile", "--preset", "skin1", "--model", "dipole", "--export", system],
            capture_output=True,
            text=True,
            check=True,
        )
        assert dermis.profile.export(skin1, system) == json.loads(said.stdout)
    for name in dermis.profile.kernels():
        said = subprocess.run(
            [program, "profile", "--preset", "skin1", "--model", "dipole", "--export", name],
            capture_output=True,
            text=True,
            check=True,
        )
        assert dermis.profile.kernel(skin1, name).values == json.loads(said.stdout)
    with pytest.raises(dermis.InputError, match="did you mean 'cycles'"):
        dermis.profile.export(skin1, "cyclse")


def test_kernels_are_files(skin1: dermis.Profile, tmp_path: Path) -> None:
    kernel = dermis.profile.kernel(skin1, "separable-kernel", taps=9)
    kernel.save(tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        f"separable-kernel.{ending}" for ending in ("glsl", "h", "json")
    ]
    with pytest.raises(dermis.InputError, match="no such folder"):
        kernel.save(tmp_path / "none")
    with pytest.raises(dermis.InputError):
        dermis.profile.kernel(skin1, "separable-kernel", taps=8)


def test_a_table_of_gaussians_is_those_gaussians() -> None:
    published = dermis.Profile.load("skin")
    r = np.linspace(0, 16, 4000)
    found = dermis.profile.fit(r, 0.8 * published.reflectance(r), gaussians=6)
    at = np.geomspace(0.05, 4, 40)
    assert np.abs(found.reflectance(at) / published.reflectance(at) / 0.8 - 1)[:, 0].max() < 0.1
    assert np.allclose(found.total_reflectance, 0.8 * published.total_reflectance, rtol=1e-3)


@pytest.mark.parametrize(
    "r_mm, reflectance, message",
    [
        ([0, 1], np.ones((3, 3)), r"^r_mm must have the shape \(N,\) and reflectance \(N, 3\)"),
        ([0, 1], [[1, 1, 1], [np.nan, 0, 0]], r"^reflectance must be finite"),
        ([0, 1], [["a", "b", "c"]] * 2, r"^reflectance must be real numbers"),
        ([1, 0], np.ones((2, 3)), r"^table"),
        ([0, 1], -np.ones((2, 3)), r"^table"),
        ([0, 9], np.ones((2, 3)), r"R in 1/mm\^2"),
    ],
)
def test_wrong_tables_are_refused(r_mm: Any, reflectance: Any, message: str) -> None:
    with pytest.raises(dermis.InputError, match=message) as error:
        dermis.profile.fit(r_mm, reflectance)
    assert "\n" not in str(error.value)


def test_a_colour_is_a_skin() -> None:
    skin, distance = dermis.profile.skin_of_colour("65,7.1,13.3")
    darker, _ = dermis.profile.skin_of_colour("38.14,12.66,15.04")
    assert distance < 4 and 0 < float(skin["melanin"]) < float(darker["melanin"])
    profile = dermis.profile.of_colour("65,7.1,13.3", model="multipole", gaussians=4)
    assert profile.total_reflectance[0] > profile.total_reflectance[2]
    with pytest.raises(dermis.InputError, match="colour"):
        dermis.profile.skin_of_colour("pink-ish")


def test_what_is_exported_comes_back() -> None:
    text = "unity reflectance=0.8,0.5,0.4 scattering_distance=0.76,0.32,0.2"
    out = dermis.profile.export(dermis.profile.of_import(text, gaussians=4), "unity")["parameters"]
    distance = np.array(out["scatteringDistance"]) * out["scatteringDistanceMultiplier"]
    assert np.allclose(distance, (0.76, 0.32, 0.2), rtol=5e-3)
    with pytest.raises(dermis.InputError, match="unity"):
        dermis.profile.of_import("unitty reflectance=1")


def test_curves_are_what_was_fitted(skin1: dermis.Profile, tmp_path: Path) -> None:
    curve = dermis.profile.curve(skin1)
    assert curve.reflectance.shape == curve.standard_error.shape == (len(curve.r_mm), 3)
    middle = (curve.r_mm > 0.5) & (curve.r_mm < 3)
    ratio = skin1.reflectance(curve.r_mm[middle]) / curve.reflectance[middle]
    assert np.abs(ratio - 1).max() < 0.15
    skin1.save(tmp_path / "skin.json")
    with pytest.raises(dermis.InputError, match="has no curves"):
        dermis.profile.curve(dermis.Profile.load(tmp_path / "skin.json"))


def test_profiles_are_drawn(skin1: dermis.Profile) -> None:
    matplotlib: Any = pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    matplotlib.use("Agg")
    axes = dermis.profile.plot([skin1, dermis.Profile.load("skin")])
    assert len(axes.lines) == 3 * 3, "two fits, one model"
    assert axes.get_xscale() == "log"
