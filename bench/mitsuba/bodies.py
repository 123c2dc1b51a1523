# SPDX-License-Identifier: MIT
"""Closed meshes, for both renderers: a ball, a slab, and the head of a glTF file."""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Body:
    about: str
    positions_m: NDArray[np.float64]
    triangles: NDArray[np.int64]
    normals: NDArray[np.float64]
    uv: NDArray[np.float64]


@dataclass(frozen=True)
class Source:
    file: Path
    metres_per_unit: float


def make(name: str, head: Source | None) -> Body:
    if name == "ball":
        return ball(0.01)
    if name == "slab":
        return slab(0.04, 0.004)
    assert head is not None
    return head_of(head, 2 if name == "rounded head" else 0)


def ball(radius_m: float, rings: int = 96) -> Body:
    p, t = np.meshgrid(np.linspace(0, 2 * np.pi, 2 * rings + 1), np.linspace(0, np.pi, rings + 1))
    n = np.column_stack([(np.sin(t) * np.sin(p)).ravel(), np.cos(t).ravel(), (np.sin(t) * np.cos(p)).ravel()])
    at = np.arange(p.size).reshape(p.shape)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, :-1].ravel(), at[1:, 1:].ravel()
    # One triangle of each quad at the poles has no area.
    triangles = np.concatenate(
        [np.column_stack([a, c, b])[2 * rings :], np.column_stack([b, c, d])[: -2 * rings]]
    )
    uv = np.column_stack([p.ravel() / (2 * np.pi), t.ravel() / np.pi])
    return Body(f"ball of radius {1000 * radius_m:g} mm", radius_m * n, triangles, n, uv)


def slab(side_m: float, thickness_m: float) -> Body:
    positions: list[NDArray[np.float64]] = []
    normals: list[NDArray[np.float64]] = []
    triangles: list[list[int]] = []
    half = np.array([side_m, side_m, thickness_m]) / 2
    for axis in range(3):
        for sign in (-1.0, 1.0):
            n = np.zeros(3)
            n[axis] = sign
            u = np.roll(np.array([1.0, 0, 0]), (axis + 1) % 3)
            v = np.cross(n, u)
            first = len(positions)
            for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                positions.append((n + x * u + y * v) * half)
                normals.append(n)
            triangles += [[first, first + 1, first + 2], [first, first + 2, first + 3]]
    uv = np.tile([[0.0, 0], [1, 0], [1, 1], [0, 1]], (6, 1))
    return Body(
        f"slab of {1000 * side_m:g} x {1000 * side_m:g} x {1000 * thickness_m:g} mm",
        np.array(positions),
        np.array(triangles),
        np.array(normals),
        uv,
    )


def head_of(head: Source, rounds: int) -> Body:
    """The largest mesh of a .glb, welded, with smooth normals; `rounds`: how often each triangle is cut in
    four that follow them. Raises ValueError: it has a hole."""
    positions, triangles = read_glb(head.file)
    positions, welded = np.unique(positions.round(7), axis=0, return_inverse=True)
    triangles = welded.reshape(-1)[triangles]
    a, b, c = (triangles[:, i] for i in range(3))
    triangles = triangles[(a != b) & (b != c) & (c != a)]
    edges = {(int(t[i]), int(t[(i + 1) % 3])) for t in triangles for i in range(3)}
    if any((b, a) not in edges for a, b in edges):
        raise ValueError(f"{head.file}: its largest mesh has holes, through which light would be lost")
    positions = positions * head.metres_per_unit
    for _ in range(rounds):
        positions, triangles = rounder(positions, triangles, smooth_normals(positions, triangles))
    normals = smooth_normals(positions, triangles)
    extent = np.ptp(positions, axis=0)
    uv = ((positions - positions.min(0)) / extent)[:, :2]
    about = head.file.name + (f", rounded {rounds} times" if rounds else "")
    return Body(about, positions, triangles, normals, uv)


def smooth_normals(positions: NDArray[np.float64], triangles: NDArray[np.int64]) -> NDArray[np.float64]:
    corners = positions[triangles]
    areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = np.zeros_like(positions)
    for i in range(3):
        np.add.at(normals, triangles[:, i], areas)
    unit: NDArray[np.float64] = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    return unit


def rounder(
    positions: NDArray[np.float64], triangles: NDArray[np.int64], normals: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Phong tessellation (Boubekeur and Alexa 2008): the middle of an edge moves half way to the tangent
    planes of its ends."""
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, place = np.unique(edges, axis=0, return_inverse=True)
    a, b = edges[:, 0], edges[:, 1]
    along = positions[b] - positions[a]
    on_a = positions[b] - (along * normals[a]).sum(1, keepdims=True) * normals[a]
    on_b = positions[a] + (along * normals[b]).sum(1, keepdims=True) * normals[b]
    middles = (positions[a] + positions[b] + on_a + on_b) / 4
    m = len(positions) + place.reshape(-1, 3)
    t = triangles
    finer = np.concatenate(
        [
            np.column_stack([t[:, 0], m[:, 0], m[:, 2]]),
            np.column_stack([t[:, 1], m[:, 1], m[:, 0]]),
            np.column_stack([t[:, 2], m[:, 2], m[:, 1]]),
            m,
        ]
    )
    return np.vstack([positions, middles]), finer


def read_glb(file: Path) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    data = file.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    root: dict[str, Any] = json.loads(data[20 : 20 + length])
    binary = data[20 + length + 8 :]
    kinds = {5121: "u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
    counts = {"SCALAR": 1, "VEC3": 3}

    def read(number: int) -> NDArray[Any]:
        accessor = root["accessors"][number]
        view = root["bufferViews"][accessor["bufferView"]]
        at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        columns = counts[accessor["type"]]
        kind = np.dtype(kinds[accessor["componentType"]])
        assert view.get("byteStride", columns * kind.itemsize) == columns * kind.itemsize
        return np.frombuffer(binary, kind, accessor["count"] * columns, at).reshape(-1, columns)

    parts = [part for mesh in root["meshes"] for part in mesh["primitives"]]
    part = max(parts, key=lambda p: int(root["accessors"][p["indices"]]["count"]))
    return read(part["attributes"]["POSITION"]).astype(np.float64), read(part["indices"]).reshape(
        -1, 3
    ).astype(np.int64)


def write_ply(file: Path, positions: NDArray[np.float64], body: Body) -> Path:
    """Writes positions, in the unit of the scene, and the normals and triangles of the body."""
    lines = [f"element vertex {len(positions)}"]
    lines += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    lines += [f"element face {len(body.triangles)}", "property list uchar int vertex_indices"]
    head = "\n".join(["ply", "format binary_little_endian 1.0", *lines, "end_header", ""])
    faces = np.zeros(len(body.triangles), [("n", "u1"), ("v", "<i4", 3)])
    faces["n"], faces["v"] = 3, body.triangles
    vertices = np.hstack([positions, body.normals]).astype("<f4")
    file.write_bytes(head.encode() + vertices.tobytes() + faces.tobytes())
    return file
