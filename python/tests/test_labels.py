# SPDX-License-Identifier: MIT
"""Labels in closed form, and K, R, t against what is drawn."""

from typing import Any

import numpy as np
from conftest import ball, skin_of, square
from numpy.typing import NDArray

import dermis

seen: dict[str, Any] = {
    "size": (96, 80),
    "map_size": 64,
    "shadow_size": 64,
    "exposure": 0.0,
    "technique": "lambert",
}
labels: Any = ("depth", "normal", "uv", "instance", "region")


def rays(camera: dermis.Camera) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The eye, and directions through the middles of pixels (H, W, 3) whose depth is 1 m per unit."""
    y, x = np.mgrid[0 : camera.height, 0 : camera.width]
    in_camera = np.stack([x, y, np.ones_like(x)], axis=-1) @ np.linalg.inv(camera.K).T
    return -camera.R.T @ camera.t, in_camera @ camera.R


def test_of_a_plane_in_closed_form(renderer: dermis.Renderer) -> None:
    scene = dermis.Scene(skin_of(square(0.2)))
    view = {**seen, "eye": (0.1, 0.07, 0.7), "target": (0.01, 0.0, 0.0), "fov": 20.0}
    frame = renderer.session(labels).draw(scene, **view)
    camera = scene.camera(**view)
    eye, along = rays(camera)
    depth = -eye[2] / along[..., 2]
    hit = eye + depth[..., None] * along
    inside = np.abs(hit[..., :2]).max(axis=-1) < 0.0999
    outside = np.abs(hit[..., :2]).max(axis=-1) > 0.1001
    assert inside.sum() > 2000 and outside.sum() > 500

    assert np.abs(frame.depth - depth)[inside].max() < 5e-6
    assert np.isinf(frame.depth[outside]).all()
    assert np.abs(frame.normal - (0, 0, 1))[inside].max() < 2e-6
    assert (frame.normal[outside] == 0).all()
    uv = np.stack([0.5 + hit[..., 0] / 0.2, 0.5 - hit[..., 1] / 0.2], axis=-1)
    assert np.abs(frame.uv - uv)[inside].max() < 1e-4
    assert (frame.instance[inside] == 1).all() and (frame.instance[outside] == 0).all()
    assert (frame.region[inside] == 3).all()


def test_of_a_ball_in_closed_form(renderer: dermis.Renderer) -> None:
    radius_m = 0.08
    scene = dermis.Scene(skin_of(ball(radius_m)))
    view = {**seen, "eye": (0.2, 0.1, 0.6), "target": (0.0, 0.0, 0.0), "fov": 20.0}
    frame = renderer.session(labels).draw(scene, **view)
    camera = scene.camera(**view)
    eye, along = rays(camera)
    unit = along / np.linalg.norm(along, axis=-1, keepdims=True)
    b = (unit * eye).sum(axis=-1)
    under = b * b - eye @ eye + radius_m**2
    inside = under > (0.3 * radius_m) ** 2
    distance = -b - np.sqrt(np.maximum(under, 0))
    hit = eye + distance[..., None] * unit
    depth = distance / np.linalg.norm(along, axis=-1)
    assert inside.sum() > 1000
    # Triangles lie up to 2 radius (1 - cos(pi / 192)) inside the ball, and are seen under a cosine of 0.3.
    assert np.abs(frame.depth - depth)[inside].max() < 2 * radius_m * (1 - np.cos(np.pi / 192)) / 0.3
    assert np.abs(frame.normal - hit / radius_m)[inside].max() < 2e-3
    # In the camera, +z ahead: what is seen looks back at the eye, and in the middle of the ball straight.
    in_camera = frame.normal @ camera.R.T
    assert in_camera[inside][:, 2].max() < 0
    assert np.abs(in_camera - (hit / radius_m) @ camera.R.T)[inside].max() < 2e-3
    assert np.abs(in_camera[39:41, 47:49].mean(axis=(0, 1)) - (0, 0, -1)).max() < 2e-3
    assert (frame.instance[under < -((0.1 * radius_m) ** 2)] == 0).all()


def test_posed_vertices_lie_where_they_are_seen(renderer: dermis.Renderer, head: dermis.Asset) -> None:
    """Of a posed, turned head: vertices whose pixel shows their depth, nearly all that face the camera."""
    scene = dermis.Scene(head)
    instance = scene.instances[0]
    c, s = np.cos(0.4), np.sin(0.4)
    instance.transform = [[c, 0, s, 0.02], [0, 1, 0, 0.01], [-s, 0, c, 0], [0, 0, 0, 1]]
    instance.pose(dermis.Pose(weights={name: 0.4 for name in head.morph_weights[:3]}))
    view = {**seen, "size": (400, 400), "eye": (0.1, 0.0, 1.0), "target": (0.0, 0.0, 0.0)}
    camera = scene.camera(**view)
    frame = renderer.session(("depth", "region")).draw(scene, **view)

    points = instance.positions_m(np.arange(0, 8000, 7))
    pixels = camera.project(points)
    x, y = np.rint(pixels[:, 0]).astype(int), np.rint(pixels[:, 1]).astype(int)
    inside = (x >= 1) & (x < 399) & (y >= 1) & (y < 399)
    off = np.abs(frame.depth[y[inside], x[inside]] - pixels[inside, 2])
    assert inside.sum() > 500
    assert (off < 1e-3).mean() > 0.25, "those that nothing hides"

    # By NumPy alone, from the pose at rest: the transform of the instance.
    at_rest = dermis.Scene(head)
    at_rest.instances[0].pose(dermis.Pose(weights={name: 0.4 for name in head.morph_weights[:3]}))
    loaded = at_rest.instances[0].positions_m(np.arange(0, 8000, 7))
    by_hand = loaded @ instance.transform[:3, :3].T + instance.transform[:3, 3]
    assert np.abs(camera.project(by_hand)[:, :2] - pixels[:, :2]).max() < 0.01, "pixels"
    moved = np.abs(loaded - dermis.Scene(head).instances[0].positions_m(np.arange(0, 8000, 7))).max()
    assert moved > 1e-3, "the pose moves something"


def test_motion_is_that_of_the_camera(renderer: dermis.Renderer) -> None:
    scene = dermis.Scene(skin_of(square(0.4)))
    session = renderer.session("motion")
    session.draw(scene, **seen, eye=(0, 0, 1), target=(0, 0, 0), fov=20.0)
    frame = session.draw(scene, **seen, eye=(0.01, 0, 1), target=(0.01, 0, 0), fov=20.0)
    focal = scene.camera(**seen, eye=(0, 0, 1), target=(0, 0, 0), fov=20.0).K[0, 0]
    assert np.abs(frame.motion[40, 48] - (-0.01 * focal, 0)).max() < 1e-3


def test_without_perspective() -> None:
    camera = dermis.Camera(
        K=np.array([[100.0, 0, 50], [0, 100, 40], [0, 0, 1]]),
        R=np.eye(3),
        t=np.array([0.0, 0, 2]),
        width=100,
        height=80,
        near_m=0.1,
        orthographic=True,
    )
    assert np.allclose(camera.project([[0.1, 0.2, 3.0]]), [[60, 60, 5]])
