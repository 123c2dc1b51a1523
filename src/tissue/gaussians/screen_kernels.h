// SPDX-License-Identifier: MIT
// Kernels with which techniques in screen space gather light, as tables of taps.
// Based on:
// [JZJ15] Jimenez, Zsolnai, Jarabo et al.: Separable Subsurface Scattering. CGF 34(6), 2015, and the kernel
//         rule that its authors published with their demo
// [CB15]  Christensen, Burley: Approximate Reflectance Profiles for Efficient Subsurface Scattering. Pixar
//         TM 15-04, 2015 (normalised diffusion)
// [JSG09] Jimenez, Sundstedt, Gutierrez: Screen-Space Perceptual Rendering of Human Skin. TAP 6(4), 2009, and
//         the demo of its authors
#pragma once

#include <vector>

#include "tissue/gaussians/sum.h"

namespace dermis::gaussians {

/// One tap of a kernel of one dimension.
struct LineTap {
  double offset = 0;  ///< along the axis, in the unit of the kernel
  Rgb weight{};
};

/// Least and most taps of a kernel of one dimension; their number is odd.
inline constexpr int least_line_taps = 3, most_line_taps = 33;

/// Returns the kernel of the authors of [JZJ15] with the default strength and falloff of their demo, for any
/// skin. Offsets are -3..3 (up to 20 taps -2..2), the middle first and the others in order. Weights of a
/// channel sum to 1. It is an artist's kernel: a radial profile read as weights, of which the part of light
/// that "strength" leaves out stays where it is.
std::vector<LineTap> published_line_kernel(int taps);

/// Returns the line spread of a profile, int R(sqrt(x^2 + y^2)) dy = sum_i w_i g(x, sigma_i), as taps of the
/// same spacing rule; offsets in mm. A weight is the integral over the cell of its tap, to infinity for the
/// outer two. Straight edges along the axes come out exactly, but for the steps between taps. Weights of a
/// channel are divided by their sum; a channel without weight keeps its light in the middle.
std::vector<LineTap> line_spread_kernel(const ScatterProfile& profile, int taps);

/// Returns how far that kernel reaches, mm: 7.5 mm for the published six Gaussians, and in proportion to the
/// widest Gaussian (2.755 sigma) for others.
double line_kernel_reach_mm(const ScatterProfile& profile);

/// A profile as a part that is not blurred, and Gaussians with weights that sum to 1 beside it.
struct PartlyBlurred {
  Rgb unblurred{};
  std::vector<Gaussian> terms;
};

/// Returns the skin of the demo of [JSG09], reduced from six Gaussians to three and a part that is not
/// blurred.
PartlyBlurred published_skin_gaussians();

/// A profile as [CB15] has it: R(r) = (e^(-r/d) + e^(-r/3d)) / (8 pi d r), d in mm per channel, with the
/// variance of this sum of Gaussians: 7 d^2 = sum_i w_i v_i.
Rgb burley_distances_mm(const ScatterProfile& profile);

/// A tap of a disc.
struct DiscTap {
  double x_mm = 0, y_mm = 0;  ///< in the plane that faces the camera
  double radius_mm = 0;
  double per_density_mm2 = 0;  ///< 1 / the density of taps there: what a profile is multiplied by
};

/// Returns `taps` (>= 1) taps distributed by the channel that spreads widest. Radii are the inverse of its
/// share of light within a radius at (i + 1/2) / taps, angles turn by the golden angle. The same for every
/// pixel and every frame.
std::vector<DiscTap> disc_taps(const ScatterProfile& profile, int taps);
/// The same for normalised diffusion.
std::vector<DiscTap> burley_disc_taps(const Rgb& distances_mm, int taps);

/// Returns the radius that holds this share (0 <= share < 1) of the light of a channel, mm.
double radius_of_share_mm(const ScatterProfile& profile, std::size_t channel, double share);
/// Returns the channel that spreads widest.
std::size_t widest_channel(const ScatterProfile& profile);
/// Returns the radius that holds this share of its light.
double disc_reach_mm(const ScatterProfile& profile, double share);
/// The same for normalised diffusion at d = 1 mm: radii are in proportion to d.
double burley_radius_of_share(double share);

}  // namespace dermis::gaussians
