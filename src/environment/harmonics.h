// SPDX-License-Identifier: MIT
/// Light from all directions as a few numbers: real spherical harmonics up to order 5, about +Y, so that
/// turning the surroundings is cheap. Based on: [SKS02] Sloan, Kautz, Snyder: Precomputed Radiance Transfer
/// for Real-Time Rendering in Dynamic, Low-Frequency Lighting
///           Environments. SIGGRAPH 2002
///           [RH01]  Ramamoorthi, Hanrahan: An Efficient Representation for Irradiance Environment Maps.
///           SIGGRAPH 2001
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "image/image.h"

namespace dermis::environment {

/// Order 5 is where what a face sees of three soft boxes is within 3 % of the exact integral (2: 17 %, 3: 9
/// %, 4: 5 %).
inline constexpr int harmonic_order = 5;
inline constexpr std::size_t harmonic_terms = (harmonic_order + 1) * (harmonic_order + 1);

/// Number l (l + 1) + m: order l, degree m; m < 0 holds the sine. Orthonormal over the sphere.
using Harmonics = std::array<double, harmonic_terms>;
Harmonics harmonics(const glm::dvec3& direction);

/// Of max(0, cos) about a unit normal: its zonal factors are pi, 2 pi / 3, pi / 4, 0, -pi / 24, 0 [RH01]
/// eq. 8.
Harmonics cosine_lobe(const glm::dvec3& normal);

/// Radiance of an equirectangular picture, three channels: Int L Y over the sphere.
using SkyHarmonics = std::array<glm::dvec3, harmonic_terms>;
SkyHarmonics sky_of(const image::ImageF& picture);

/// Irradiance on an unoccluded surface of the unit normal, of the terms up to an order: may be below 0, where
/// the sum rings.
glm::dvec3 irradiance_of(const SkyHarmonics& sky, const glm::dvec3& normal, int order = harmonic_order);

/// The same surroundings, blurred no more than it takes for that irradiance to be nowhere below 0: the term
/// of order l by 1 / (1 + lambda l^2 (l+1)^2), lambda >= 0 the least that does. The mean stays. What does not
/// ring is returned as it is. Based on: [S08] Sloan: Stupid Spherical Harmonics Tricks. GDC 2008, "Windowing"
SkyHarmonics without_ringing(const SkyHarmonics& sky, int order = harmonic_order);

/// The same surroundings turned about +Y, from the head's front (+Z) towards its left (+X).
SkyHarmonics turned(const SkyHarmonics& sky, double angle_rad);

}  // namespace dermis::environment
