# SPDX-License-Identifier: MIT
"""The module as it is installed: what it needs, what it says of itself, its types."""

import re
import subprocess
import sys
from importlib.metadata import distribution
from pathlib import Path

import numpy as np
import pytest

import dermis
import dermis.compare
import dermis.profile
import dermis.reference
from dermis import _core, doctor
from dermis._keywords import render_keywords

# Beside what every machine has. libvulkan.so.1 is opened when a device is asked for.
libraries = {
    "libOpenEXR-3_1.so.30",
    "libdraco.so.7",
    "libembree3.so.3",
    "libfmt.so.9",
    "libjpeg.so.62",
    "libmeshoptimizer.so.2d",
    "libspirv-cross-c-shared.so.0",
    "libspng.so.0",
    "libtbb.so.12",
}
of_the_system = {"libstdc++.so.6", "libm.so.6", "libgcc_s.so.1", "libc.so.6", "ld-linux-x86-64.so.2"}


def test_needs_these_libraries_and_no_others() -> None:
    elf = pytest.importorskip("elftools.elf.elffile")
    with open(str(_core.__file__), "rb") as file:
        dynamic = elf.ELFFile(file).get_section_by_name(".dynamic")
        needed = {tag.needed for tag in dynamic.iter_tags() if tag.entry.d_tag == "DT_NEEDED"}
    assert needed - of_the_system == libraries


def test_includes_public_headers_alone() -> None:
    source = Path(__file__).parent.parent / "src"
    own = {path.name for path in source.glob("*.h")}
    for path in source.iterdir():
        for name in re.findall(r'^#include "(.*)"$', path.read_text(), re.M):
            public = name.startswith("dermis/") and (source.parent.parent / "include" / name).is_file()
            assert name in own or public, f"{path.name}: {name}"


def test_is_tagged_for_its_platform() -> None:
    wheel = distribution("dermis").read_text("WHEEL")
    assert wheel is not None
    tags = [line.removeprefix("Tag: ") for line in wheel.splitlines() if line.startswith("Tag: ")]
    version = f"cp{sys.version_info.major}{sys.version_info.minor}"
    assert [tag.split("-")[:2] for tag in tags] == [[version, version]]
    assert "linux" in tags[0] and "any" not in tags[0]


def test_checks_by_mypy_strict() -> None:
    pytest.importorskip("mypy")
    here = Path(__file__).parent
    for what in (["-p", "dermis"], [str(file) for file in sorted(here.glob("*.py"))]):
        result = subprocess.run(
            [sys.executable, "-m", "mypy", "--strict", *what], cwd=here, capture_output=True, text=True
        )
        assert result.returncode == 0, result.stdout


def test_types_of_keywords_are_those_of_the_rows() -> None:
    from dermis._types import RenderKeywords

    assert set(RenderKeywords.__annotations__) == {*render_keywords.rows, "size"}


def test_everything_has_a_docstring() -> None:
    for module in (dermis.compare, dermis.profile, dermis.reference):
        assert module.__doc__
        for name in set(module.__all__) - {"Progress"}:  # a type
            assert getattr(module, name).__doc__, f"{module.__name__}.{name}"
    for name in dermis.__all__:
        thing = getattr(dermis, name)
        assert thing.__doc__, name
        for member, value in vars(thing).items():
            if callable(value) and not member.startswith("_") and isinstance(thing, type):
                if name not in ("Scene", "Instance") or member not in ("add", "remove", "add_light"):
                    assert value.__doc__, f"{name}.{member}"


def test_the_doctor_draws() -> None:
    result = subprocess.run([sys.executable, "-m", "dermis.doctor"], capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr
    for word in ("python", "numpy", "device", "picture"):
        assert word in result.stdout


def test_the_doctor_says_what_is_missing() -> None:
    assert doctor.advice("libembree3.so.3: cannot open shared object file") == "apt-get install libembree3-3"
    assert (
        doctor.advice("libOpenEXR-3_1.so.30: cannot open shared object")
        == "apt-get install libopenexr-3-1-30"
    )
    assert "pip install" in doctor.advice("undefined symbol: x")
    without = subprocess.run(
        [sys.executable, "-m", "dermis.doctor"],
        capture_output=True,
        text=True,
        env={"PATH": "/usr/bin", "VK_DRIVER_FILES": "/nowhere", "VK_ICD_FILENAMES": "/nowhere"},
    )
    assert without.returncode == 1 and "no device can be used" in without.stdout, (
        without.stdout + without.stderr
    )


def test_profiles_are_arrays(tmp_path: Path) -> None:
    profile = dermis.Profile.load("skin")
    assert profile.variances_mm2.shape == (6,) and profile.weights.shape == (6, 3)
    assert np.allclose(profile.weights.sum(axis=0), 1, atol=2e-3)
    r = np.linspace(0, 3, 7)
    v, w = profile.variances_mm2, profile.weights
    closed = (w * np.exp(-r[:, None, None] ** 2 / (2 * v[:, None])) / (2 * np.pi * v[:, None])).sum(axis=1)
    assert np.allclose(profile.reflectance(r), closed * profile.total_reflectance, rtol=1e-6)
    made = dermis.Profile.of_skin(melanin=0.05)
    made.save(tmp_path / "skin.json")
    assert np.array_equal(dermis.Profile.load(tmp_path / "skin.json").weights, made.weights)
    with pytest.raises(dermis.InputError, match="melanin"):
        dermis.Profile.of_skin(melanin=2)
    with pytest.raises(dermis.InputError):
        dermis.Profile.of_coefficients((1, 2), (1, 2, 3))
