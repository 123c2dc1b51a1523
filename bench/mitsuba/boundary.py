# SPDX-License-Identifier: MIT
"""The boundary of the reference's model `volume`, as a BSDF of Mitsuba 3.

A camera ray enters by Snell's law. Inside, each face reflects with Fresnel's probability. Where light
enters it spreads as through a rough surface: along the walk its radiance is E / pi. Light that left skin
does not light other skin.
"""

from __future__ import annotations

import math
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

_flags = mi.BSDFFlags


def _refracted(si: Any, wi: Any, eta: float) -> tuple[Any, Any, Any]:
    """Returns Fresnel's reflectance, the refraction of -wi, and whether wi lies outside."""
    cos_i = dr.dot(si.n, wi)
    f, cos_t, _, eta_ti = mi.fresnel(cos_i, eta)
    n = dr.select(cos_i > 0, si.n, -si.n)
    return f, dr.normalize(-eta_ti * wi + (dr.abs(cos_i) * eta_ti - dr.abs(cos_t)) * n), cos_i > 0


class RoughEntry(mi.BSDF):  # type: ignore[misc, name-defined]
    """`diffuse_camera`: in place of a camera ray, diffuse light enters through a polished surface, for the
    total by which `volume` divides."""

    def __init__(self, props: Any) -> None:
        super().__init__(props)
        self.eta = props["eta"]
        self.diffuse_camera = props.get("diffuse_camera", False)
        cosines = (np.arange(20_000) + 0.5) / 20_000
        reflected = np.array(mi.fresnel(mi.Float(cosines), self.eta)[0])
        self.entering_share = float(np.mean(2 * cosines * (1 - reflected)))
        self.m_components = [
            _flags.DeltaTransmission | _flags.FrontSide,
            _flags.DeltaReflection | _flags.BackSide,
            _flags.DiffuseTransmission | _flags.BackSide,
        ]
        self.m_flags = self.m_components[0] | self.m_components[1] | self.m_components[2]

    def sample(self, ctx: Any, si: Any, sample1: Any, sample2: Any, active: Any) -> tuple[Any, Any]:
        wi = si.to_world(si.wi)
        f, inwards, outside = _refracted(si, wi, self.eta)
        weight = mi.Float(1.0)
        if self.diffuse_camera:
            to_light = mi.Frame3f(si.n).to_world(mi.warp.square_to_cosine_hemisphere(sample2))
            lost, entering, _ = _refracted(si, to_light, self.eta)
            inwards = dr.select(outside, entering, inwards)
            weight = dr.select(outside, (1 - lost) / self.entering_share, 1.0)
        reflected = 2 * dr.dot(si.n, wi) * si.n - wi
        sample = dr.zeros(mi.BSDFSample3f)
        sample.wo = si.to_local(dr.select(outside, inwards, reflected))
        sample.pdf = dr.select(outside, 1.0, f)
        sample.eta = 1.0
        sample.sampled_type = dr.select(
            outside, mi.UInt32(+_flags.DeltaTransmission), mi.UInt32(+_flags.DeltaReflection)
        )
        # What would leave ends here: the lamps of eval() have been asked.
        goes_on = active & (outside | (sample1 < f))
        return sample, dr.select(goes_on, mi.Spectrum(weight), mi.Spectrum(0.0))

    def eval(self, ctx: Any, si: Any, wo: Any, active: Any) -> Any:
        f, _, outside = _refracted(si, si.to_world(si.wi), self.eta)
        lit = active & ~outside & (dr.dot(si.n, si.to_world(wo)) > 0) & (wo.z > 0)
        return dr.select(lit, mi.Spectrum((1 - f) / math.pi * wo.z), mi.Spectrum(0.0))

    def pdf(self, ctx: Any, si: Any, wo: Any, active: Any) -> Any:
        return mi.Float(0.0)

    def eval_pdf(self, ctx: Any, si: Any, wo: Any, active: Any) -> tuple[Any, Any]:
        return self.eval(ctx, si, wo, active), mi.Float(0.0)


def register() -> None:
    mi.register_bsdf("rough_entry", RoughEntry)
