# SPDX-License-Identifier: MIT
"""What the tests share. DERMIS_PROGRAM names the command line; tests that need it are skipped without."""

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dermis

small: dict[str, Any] = {"size": (64, 48), "map_size": 256, "shadow_size": 256, "exposure": 0}


@pytest.fixture(scope="session")
def renderer() -> dermis.Renderer:
    return dermis.Renderer()


@pytest.fixture(scope="session")
def head() -> dermis.Asset:
    return dermis.Asset.load("built-in")


@pytest.fixture
def scene(head: dermis.Asset) -> dermis.Scene:
    return dermis.Scene(head)


@pytest.fixture(scope="session")
def program() -> Path:
    path = Path(os.environ.get("DERMIS_PROGRAM", ""))
    if not path.is_file():
        pytest.skip("DERMIS_PROGRAM names no program")
    return path


def square(side_m: float = 0.2, cells: int = 8) -> dermis.Mesh:
    """A square of skin in the plane z = 0, seen from +z; uv (0, 0) is its upper left corner."""
    t = np.linspace(0, 1, cells + 1)
    u, v = np.meshgrid(t, t)
    positions = np.column_stack([(u.ravel() - 0.5) * side_m, (0.5 - v.ravel()) * side_m, np.zeros(u.size)])
    at = np.arange(u.size).reshape(u.shape)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, :-1].ravel(), at[1:, 1:].ravel()
    triangles = np.concatenate([np.column_stack([a, c, b]), np.column_stack([b, c, d])])
    return dermis.Mesh(positions=positions, indices=triangles, uv=np.column_stack([u.ravel(), v.ravel()]))


def ball(radius_m: float = 0.08, rings: int = 96) -> dermis.Mesh:
    theta = np.linspace(0, np.pi, rings + 1)
    phi = np.linspace(0, 2 * np.pi, 2 * rings + 1)
    p, t = np.meshgrid(phi, theta)
    normals = np.column_stack(
        [(np.sin(t) * np.sin(p)).ravel(), np.cos(t).ravel(), (np.sin(t) * np.cos(p)).ravel()]
    )
    at = np.arange(p.size).reshape(p.shape)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, :-1].ravel(), at[1:, 1:].ravel()
    triangles = np.concatenate([np.column_stack([a, c, b]), np.column_stack([b, c, d])])
    uv = np.column_stack([p.ravel() / (2 * np.pi), t.ravel() / np.pi])
    return dermis.Mesh(positions=radius_m * normals, indices=triangles, normals=normals, uv=uv)


def skin_of(mesh: dermis.Mesh) -> dermis.Asset:
    return dermis.Asset.from_arrays([mesh], [dermis.Material(name="skin", skin=True)])
