// SPDX-License-Identifier: MIT
// Based on: [ANAMOF20], see compare_flip.h
#include "image/compare_flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dermis::image::flip {
namespace {

using std::numbers::pi;

// [ANAMOF20] table 1: contrast sensitivity as Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees.
struct Sensitivity {
  double a, b;
};
constexpr Sensitivity achromatic{1, 0.0047}, red_green{1, 0.0053}, blue_yellow_wide{34.1, 0.04},
    blue_yellow_narrow{13.5, 0.025};

// [ANAMOF20] sec. 4.2.1: the width of the feature detectors, degrees.
constexpr double feature_width_deg = 0.082;

/// Returns one factor of the two-dimensional Gaussian; both factors share its amplitude.
std::vector<double> factor(const Sensitivity& s, int radius, double pixels_per_degree) {
  std::vector<double> taps;
  for (int i = -radius; i <= radius; ++i) {
    const double x = i / pixels_per_degree;
    taps.push_back(std::sqrt(s.a * std::sqrt(pi / s.b)) * std::exp(-pi * pi * x * x / s.b));
  }
  return taps;
}

double sum(const std::vector<double>& taps) {
  double total = 0;
  for (const double tap : taps) total += tap;
  return total;
}

Taps scaled(const std::vector<double>& taps, double by) {
  Taps out;
  for (const double tap : taps) out.push_back(static_cast<float>(tap * by));
  return out;
}

/// Scales positive taps to the sum 1 and negative ones to -1.
Taps balanced(const std::vector<double>& taps) {
  double positive = 0, negative = 0;
  for (const double tap : taps) (tap > 0 ? positive : negative) += std::abs(tap);
  Taps out;
  for (const double tap : taps) out.push_back(static_cast<float>(tap / (tap > 0 ? positive : negative)));
  return out;
}

}  // namespace

Filters make_filters(double pixels_per_degree) {
  const int spatial_radius =
      static_cast<int>(std::ceil(3 * std::sqrt(blue_yellow_wide.b / (2 * pi * pi)) * pixels_per_degree));
  const double sigma = 0.5 * feature_width_deg * pixels_per_degree;
  const int feature_radius = static_cast<int>(std::ceil(3 * sigma));
  Filters f;
  f.radius = std::max(spatial_radius, feature_radius);

  const std::vector<double> y = factor(achromatic, spatial_radius, pixels_per_degree);
  const std::vector<double> cx = factor(red_green, spatial_radius, pixels_per_degree);
  const std::vector<double> wide = factor(blue_yellow_wide, spatial_radius, pixels_per_degree);
  const std::vector<double> narrow = factor(blue_yellow_narrow, spatial_radius, pixels_per_degree);
  f.y = scaled(y, 1 / sum(y));
  f.cx = scaled(cx, 1 / sum(cx));
  const double norm = 1 / std::hypot(sum(wide), sum(narrow));
  f.cz_wide = scaled(wide, norm);
  f.cz_narrow = scaled(narrow, norm);

  std::vector<double> smooth, edge, point;
  for (int x = -feature_radius; x <= feature_radius; ++x) {
    const double g = std::exp(-x * x / (2 * sigma * sigma));
    smooth.push_back(g);
    edge.push_back(-x * g);
    point.push_back((x * x / (sigma * sigma) - 1) * g);
  }
  f.smooth = scaled(smooth, 1 / sum(smooth));
  f.edge = balanced(edge);
  f.point = balanced(point);

  for (Taps* taps : {&f.y, &f.cx, &f.cz_wide, &f.cz_narrow, &f.smooth, &f.edge, &f.point}) {
    const std::size_t missing = static_cast<std::size_t>(f.radius) - taps->size() / 2;
    taps->insert(taps->begin(), missing, 0.0f);
    taps->insert(taps->end(), missing, 0.0f);
  }
  return f;
}

}  // namespace dermis::image::flip
