# SPDX-License-Identifier: MIT
"""A second opinion on the reference's model `volume`: the same mesh, camera, lamp and medium in Mitsuba 3.

usage: second_opinion.py OUT.json [--case NAME]... [--samples N] [--head FILE.glb [--scale S]]

Needs the Python module of dermis and `pip install mitsuba` (3.6 goes with LLVM 15, newer ones with newer
ones). Mitsuba follows light by `volpath`, one channel at a time, through `rough_entry` of boundary.py; the
total of the medium, by which `volume` divides, comes from Mitsuba as well. Each picture is made in ten
parts with seeds of their own, whose scatter is its noise.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import sys
import tempfile
import time
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

os.environ.setdefault("DRJIT_LIBLLVM_PATH", "/usr/lib/x86_64-linux-gnu/libLLVM-15.so.1")
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

mi.set_variant("llvm_ad_mono")
sys.path.insert(0, str(Path(__file__).parent))
import bodies  # noqa: E402
import boundary  # noqa: E402

import dermis  # noqa: E402
import dermis.compare  # noqa: E402
import dermis.reference  # noqa: E402

PARTS = 10
TOTAL_SAMPLES = 160  # of 64 x 64 pixels; the error of a total is common to all pixels
Image = NDArray[np.float64]


@dataclass(frozen=True)
class Medium:
    """Per mm, for each of three channels."""

    sigma_a: tuple[float, float, float]
    sigma_s: tuple[float, float, float]
    g: float
    eta: float

    @property
    def text(self) -> str:
        a, s = (",".join(str(x) for x in c) for c in (self.sigma_a, self.sigma_s))
        return f"sigma_a={a} sigma_s={s} g={self.g} eta={self.eta}"


# [JMLH01] skin1 and skin2; a forward lobe of the same reduced scattering as skin1.
skin1 = Medium((0.032, 0.17, 0.48), (0.74, 0.88, 1.01), 0.0, 1.3)
skin2 = Medium((0.013, 0.070, 0.145), (1.09, 1.59, 1.79), 0.0, 1.3)
forward = Medium((0.032, 0.17, 0.48), (3.7, 4.4, 5.05), 0.8, 1.4)


@dataclass(frozen=True)
class Case:
    body: str
    medium: Medium
    lamp: str = "side"
    size: int = 48
    """Pixels of a side."""
    regions_of: str = ""
    """The body that says which pixels are compared; empty: its own."""


cases = {
    "ball": Case("ball", skin1),
    "ball, forward": Case("ball", forward),
    "slab, lit from behind": Case("slab", skin2, "behind"),
    "head": Case("head", skin2, size=72),
    "rounded head": Case("rounded head", skin2, size=72, regions_of="head"),
}

lamps = {"side": (1.0, 0.2, 0.35), "behind": (0.3, 0.2, -1.0)}


def mitsuba_medium(medium: Medium, c: int) -> dict[str, Any]:
    a, s = medium.sigma_a[c], medium.sigma_s[c]
    return {
        "type": "homogeneous",
        "albedo": s / (a + s),
        "sigma_t": a + s,
        "phase": {"type": "hg", "g": medium.g},
    }


def film_of(width: int, height: int) -> dict[str, Any]:
    box = {"type": "box"}
    return {"type": "hdrfilm", "width": width, "height": height, "rfilter": box, "pixel_format": "luminance"}


def scene_of(
    shape: dict[str, Any], sensor: dict[str, Any], light: dict[str, Any], medium: Medium, c: int
) -> Any:
    # Roulette ends one walk in twenty at each scattering: only once a twentieth of the light is left.
    albedo = medium.sigma_s[c] / (medium.sigma_a[c] + medium.sigma_s[c])
    path = {
        "type": "volpath",
        "max_depth": 100_000,
        "rr_depth": math.ceil(math.log(0.05) / math.log(albedo)),
        "hide_emitters": True,
    }
    return mi.load_dict(
        {"type": "scene", "integrator": path, "sensor": sensor, "light": light, "body": shape}
    )


def rendered(scene: Any, samples: int, seed: int) -> tuple[Image, Image]:
    """Returns the mean of the parts and its variance, (H, W)."""
    per_part = max(1, samples // PARTS)
    parts = np.array(
        [np.array(mi.render(scene, spp=per_part, seed=seed + i), np.float64)[..., 0] for i in range(PARTS)]
    )
    return parts.mean(0), parts.var(0, ddof=1) / PARTS


@cache
def total_of(medium: Medium, c: int) -> tuple[float, float]:
    """Returns the share of diffuse light that a half-space returns, and its standard error."""
    look = mi.ScalarTransform4f().look_at([0, 0, 300], [0, 0, 0], [0, 1, 0])
    sensor = {"type": "orthographic", "to_world": look, "film": film_of(64, 64)}
    slab = {
        "type": "cube",
        "to_world": mi.ScalarTransform4f().scale([150, 150, 75]),
        "bsdf": {"type": "rough_entry", "eta": medium.eta, "diffuse_camera": True},
        "interior": mitsuba_medium(medium, c),
    }
    sky = {"type": "constant", "radiance": 1.0}
    mean, variance = rendered(scene_of(slab, sensor, sky, medium, c), TOTAL_SAMPLES, 100 + c)
    return float(mean.mean()), float(np.sqrt(variance.mean() / mean.size))


def sensor_of(camera: dermis.Camera, centre_m: Any) -> dict[str, Any]:
    """Our camera in mm about the middle of the body. OpenCV looks along +z with y down, Mitsuba along +z with
    x to the left."""
    to_world = np.eye(4)
    to_world[:3, :3] = np.column_stack([-camera.R[0], -camera.R[1], camera.R[2]])
    to_world[:3, 3] = 1000 * (-camera.R.T @ camera.t - centre_m)
    fov = 2 * np.degrees(np.arctan(camera.height / 2 / camera.K[1, 1]))
    return {
        "type": "perspective",
        "fov": float(fov),
        "fov_axis": "y",
        "near_clip": 1.0,
        "far_clip": 1e5,
        "to_world": mi.ScalarTransform4f(to_world),
        "film": film_of(camera.width, camera.height),
    }


def light_of(lamp: str) -> dict[str, Any]:
    towards = lamps[lamp]
    return {"type": "directional", "direction": [-x for x in towards], "irradiance": 3.0}


def our_scene(body: bodies.Body, case: Case) -> tuple[dermis.Scene, dict[str, Any]]:
    """Returns the scene and the settings of its pictures."""
    mesh = dermis.Mesh(body.positions_m, body.triangles, body.normals, body.uv)
    scene = dermis.Scene(dermis.Asset.from_arrays([mesh], [dermis.Material(name="skin", skin=True)]))
    scene.set_lights([dermis.Light(colour=(3, 3, 3), direction=[-x for x in lamps[case.lamp]])])
    size = (case.size, case.size)
    return scene, {"size": size, "exposure": 0.0, "specular": False, "ambient": 0.0, "orbit": (0.0, 0.0)}


def theirs(
    body: bodies.Body, case: Case, camera: dermis.Camera, samples: int, folder: Path
) -> tuple[Image, Image, list[tuple[float, float]]]:
    """Returns the picture over the total of the medium, its variance, and the totals."""
    centre_m = (body.positions_m.min(0) + body.positions_m.max(0)) / 2
    file = bodies.write_ply(folder / "body.ply", 1000 * (body.positions_m - centre_m), body)
    pictures, variances, totals = [], [], []
    for c in range(3):
        total, error = total_of(case.medium, c)
        shape = {
            "type": "ply",
            "filename": str(file),
            "bsdf": {"type": "rough_entry", "eta": case.medium.eta},
            "interior": mitsuba_medium(case.medium, c),
        }
        scene = scene_of(shape, sensor_of(camera, centre_m), light_of(case.lamp), case.medium, c)
        mean, variance = rendered(scene, samples, 1000 * (c + 1))
        pictures.append(mean / total)
        variances.append(variance / total**2)
        totals.append((total, error))
    return np.dstack(pictures), np.dstack(variances), totals


def rounded(values: Any, digits: int = 4) -> list[float]:
    return [float(f"{x:.{digits}g}") for x in np.atleast_1d(values)]


def compared(
    a: Image,
    a_variance: Image,
    b: Image,
    b_variance: Image,
    totals: list[tuple[float, float]],
    mask: NDArray[np.bool_],
) -> dict[str, Any]:
    """Over a region: mean colours, their ratio with its standard error, relMSE less the noise of both."""
    mean_a, mean_b = a[mask].mean(0), b[mask].mean(0)
    errors = [np.sqrt(v[mask].sum(0)) / mask.sum() for v in (a_variance, b_variance)]
    ratio = mean_b / mean_a
    of_totals = np.array([error / total for total, error in totals])
    error = ratio * np.sqrt((errors[0] / mean_a) ** 2 + (errors[1] / mean_b) ** 2 + of_totals**2)
    over = a[mask] ** 2 + 0.01
    noise = (a_variance[mask] + b_variance[mask]) / over
    return {
        "pixels": int(mask.sum()),
        "ours": rounded(mean_a),
        "mitsuba": rounded(mean_b),
        "mitsuba_over_ours": rounded(ratio, 5),
        "standard_error": rounded(error, 2),
        "rel_mse": rounded(((b[mask] - a[mask]) ** 2 / over).mean())[0],
        "rel_mse_less_noise": rounded((((b[mask] - a[mask]) ** 2) / over - noise).mean())[0],
    }


def run(name: str, samples: int, head: bodies.Source | None) -> dict[str, Any]:
    case = cases[name]
    body = bodies.make(case.body, head)
    start = time.perf_counter()
    scene, settings = our_scene(body, case)
    how: Any = {"model": "volume", "medium": case.medium.text, "samples": 4 * samples}
    truth = dermis.reference.render(scene, reference=how, **settings)
    between = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        picture, variance, totals = theirs(body, case, scene.camera(**settings), samples, Path(folder))
    end = time.perf_counter()
    if case.regions_of:
        scene, settings = our_scene(bodies.make(case.regions_of, head), case)
    regions = dermis.compare.regions(scene, **settings)
    # Pixels at the outline mix skin and nothing.
    whole = truth.linear[..., 3] > 0.999
    found = {
        region: compared(
            truth.linear[..., :3].astype(np.float64),
            truth.variance[..., :3].astype(np.float64),
            picture,
            variance,
            totals,
            mask & whole,
        )
        for region, mask in regions.items()
        if (mask & whole).sum() >= 20
    }
    return {
        "case": name,
        "body": body.about,
        "triangles": len(body.triangles),
        "lamp": case.lamp,
        "medium": case.medium.text,
        "size": [case.size, case.size],
        "samples": {"ours": 4 * samples, "mitsuba": samples},
        "totals_by_mitsuba": [rounded(t) for t in totals],
        "seconds": {"ours": round(between - start, 1), "mitsuba": round(end - between, 1)},
        "regions": found,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("--case", action="append", choices=list(cases), help="default: all")
    parser.add_argument("--samples", type=int, default=160)
    parser.add_argument("--head", type=Path, help="a .glb of one closed mesh, for the case head")
    parser.add_argument("--scale", type=float, default=1.0, help="metres per unit of that file")
    arguments = parser.parse_args()
    head = bodies.Source(arguments.head, arguments.scale) if arguments.head else None
    boundary.register()
    record: dict[str, Any] = {
        "what": "the reference's volume and Mitsuba 3, the same scene: mean colour and relMSE by region",
        "command": "bench/mitsuba/second_opinion.py OUT.json --head LeePerrySmith.glb --scale 0.053",
        "mitsuba": mi.__version__,
        "cases": [],
    }
    for name in arguments.case or list(cases):
        if "head" in cases[name].body and head is None:
            print(f"{name}: left out, it needs --head")
            continue
        record["cases"].append(run(name, arguments.samples, head))
        for region, row in record["cases"][-1]["regions"].items():
            print(
                name,
                region,
                row["mitsuba_over_ours"],
                row["standard_error"],
                row["rel_mse_less_noise"],
                flush=True,
            )
        arguments.output.write_text(json.dumps(record, indent=1) + "\n")


if __name__ == "__main__":
    main()
