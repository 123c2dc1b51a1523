// SPDX-License-Identifier: MIT
// A profile and its sum of Gaussians as a picture (SVG) for people.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tissue/gaussians/fit.h"
#include "tissue/profile/radial.h"

namespace dermis::cli {

/// A sum drawn beside the profile, for comparison. Weights that sum to 1 per channel.
struct PlottedSum {
  std::string label;
  std::array<std::vector<gaussians::Term>, 3> channels;
};

/// The content of the picture. Every curve is divided by its total, so that shapes compare.
struct ProfilePlot {
  std::string title;
  std::array<profile::ProfilePtr, 3> profiles;  ///< solid
  PlottedSum fit;                               ///< dashed
  std::vector<PlottedSum> others;               ///< dotted, each in its own way; at most 3
};

/// Top to bottom: r R(r) over log r per channel with the fit and others; the residual r (R - S); and the
/// colours of light that bleeds from a white edge into the dark, x = -2 to 8 mm or what the profile reaches,
/// E(x) = Sum w_i erfc(x / sqrt(2 v_i)) / 2, one strip a sum. A legend names the lines. About 60 kB of valid
/// XML whatever the names hold; depends on nothing but its arguments.
std::string profile_svg(const ProfilePlot& plot);

}  // namespace dermis::cli
