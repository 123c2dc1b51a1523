// SPDX-License-Identifier: MIT
// A profile and its sum of Gaussians as a picture (SVG) for people.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gaussians/fit.h"
#include "profile/radial.h"

namespace dermis::gaussians {

/// A sum drawn beside the profile, for comparison. Weights that sum to 1 per channel.
struct PlottedSum {
  std::string label;
  std::array<std::vector<Term>, 3> channels;
};

/// What the picture shows. Every curve is divided by its total, so that shapes compare.
struct Plot {
  std::string title;
  std::array<profile::ProfilePtr, 3> profiles;  ///< solid
  PlottedSum fit;                               ///< dashed
  std::vector<PlottedSum> others;               ///< dotted, each in its own way; at most 3
};

/// Top to bottom: r R(r) over log r per channel with the fit and others; the residual r (R - S); and the
/// colours of light that bleeds from a white edge into the dark, x = -2 to 8 mm or what the profile reaches,
/// E(x) = Sum w_i erfc(x / sqrt(2 v_i)) / 2, one strip a sum. A legend names the lines. About 60 kB of valid
/// XML whatever the names hold; depends on nothing but its arguments.
std::string svg_plot(const Plot& plot);

/// E(x), the light at distance x [mm] into the dark (negative: in the light) from a straight edge, 0..1 for
/// normalised weights. [DLE07] fig. 2 idea, the integral of the sum over a half-plane.
double edge_response(const std::vector<Term>& terms, double x_mm);

/// How far two normalised sums are apart, in per cent: 100 sqrt( Int r (S - S')^2 dr / Int r S^2 dr ), in
/// closed form: Int r G(v) G(v') dr = 1 / (4 pi^2 (v + v')).
double difference_percent(const std::vector<Term>& sum, const std::vector<Term>& other);

}  // namespace dermis::gaussians
