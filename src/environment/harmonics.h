// SPDX-License-Identifier: MIT
/// Light from all directions as real spherical harmonics up to order 5, about +Y, so that turning the
/// environment is cheap.
/// Based on:
/// [SKS02] Sloan, Kautz, Snyder: Precomputed Radiance Transfer for Real-Time Rendering in Dynamic,
///         Low-Frequency Lighting Environments. SIGGRAPH 2002
/// [RH01]  Ramamoorthi, Hanrahan: An Efficient Representation for Irradiance Environment Maps. SIGGRAPH 2001
/// [S08]   Sloan: Stupid Spherical Harmonics Tricks. GDC 2008
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "image/image.h"

namespace dermis::environment {

/// Order 5 gives the irradiance on a face from three soft boxes within 3 % of the exact integral (order 2: 17
/// %, 3: 9 %, 4: 5 %).
inline constexpr int harmonic_order = 5;
inline constexpr std::size_t harmonic_terms = (harmonic_order + 1) * (harmonic_order + 1);

/// Returns the entry that has order l and degree m; m < 0 holds the sine.
constexpr std::size_t harmonic_number(int l, int m) { return static_cast<std::size_t>(l * (l + 1) + m); }

/// Returns sqrt((2 l + 1) / (4 pi) (l - m)! / (l + m)!), times sqrt 2 for m > 0, where cosine and sine share
/// it; m is not below 0.
double harmonic_norm(int l, int m);

/// Entries by harmonic_number(), orthonormal over the sphere.
using Harmonics = std::array<double, harmonic_terms>;
Harmonics harmonics(const glm::dvec3& direction);

/// Returns the harmonics of max(0, cos) about a unit normal.
Harmonics cosine_lobe(const glm::dvec3& normal);

/// Returns the harmonics of an equirectangular picture of radiance, Int L Y over the sphere, per channel.
using SkyHarmonics = std::array<glm::dvec3, harmonic_terms>;
SkyHarmonics sky_of(const image::ImageF& picture);

/// Returns the irradiance on an unoccluded surface from the terms up to an order. May be below 0 where the
/// series rings.
glm::dvec3 irradiance_of(const SkyHarmonics& sky, const glm::dvec3& normal, int order = harmonic_order);

/// Returns the environment blurred just enough for that irradiance to be nowhere below 0. The mean stays; an
/// environment that does not ring is returned as it is. [S08] "Windowing".
SkyHarmonics without_ringing(const SkyHarmonics& sky);

/// Returns the environment turned about +Y, from the head's front (+Z) towards its left (+X).
SkyHarmonics turned(const SkyHarmonics& sky, double angle_rad);

/// Returns the environment in the coordinates of what is turned by this rotation: at a direction d of its own
/// it sees what the environment has at world_from_own d.
SkyHarmonics seen_from(const SkyHarmonics& sky, const glm::dmat3& world_from_own);

}  // namespace dermis::environment
