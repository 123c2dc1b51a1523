// SPDX-License-Identifier: MIT
// A plane of skin of which one half is lit, seen at a chosen resolution and tilt.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "dermis/renderer.h"
#include "dermis/scene.h"

namespace dermis::tests {

inline constexpr int plane_width = 256, plane_height = 64;  ///< of the picture, pixels

inline constexpr int middle_row = plane_height / 2;

/// White skin where x < 0, black where x > 0, in the plane z = 0, 0.3 m wide. Made once.
const Scene& lit_edge();

/// One half alone.
Asset half_plane(bool white);

/// Uniform light, no reflection, one sample, the whole albedo before scattering: the white half is 1. The
/// camera stands half a metre away, turned from the normal of the plane by `tilt_deg` towards `azimuth_deg`
/// (0: +x, 90: +y), and sees so many pixels per mm across its line of sight in the middle.
RenderSettings facing_plane(const std::string& technique, double pixels_per_mm, double tilt_deg = 0,
                            double azimuth_deg = 0);

/// Returns where the middle of a pixel sees the plane, mm.
glm::dvec2 seen_mm(const RenderSettings& settings, int x, int y);

/// Returns the light of the edge at x_mm, averaged over a width (0: there): the published six Gaussians.
std::array<double, 3> exact_edge(double x_mm, double width_mm);

/// Returns red, green and blue of a pixel.
std::array<double, 3> pixel(const Picture& picture, int x, int y);

/// Returns the largest difference in the middle row from the profile on the surface, averaged over
/// `width_mm`: a bilinear tap takes the mean over a pixel, one at the nearest pixel that of the middle.
std::array<double, 3> distance_from_exact(const Picture& picture, const RenderSettings& s, double width_mm);

/// Returns by how much red spreads, over the published width: an edge E(x) has the variance 4 int_0^inf x
/// E(x) dx.
double spread_of_red(const Picture& picture, const RenderSettings& s);

}  // namespace dermis::tests
