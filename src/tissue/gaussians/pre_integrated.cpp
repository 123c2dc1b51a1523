// SPDX-License-Identifier: MIT
#include "tissue/gaussians/pre_integrated.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/core/parallel.h"

namespace dermis::gaussians {
namespace {

using std::numbers::pi;

constexpr double wide = 8;  // sigma, beyond which a Gaussian is 0

template <class F>
double simpson(const F& f, double from, double to) {
  constexpr int halves = 32;
  if (!(from < to)) return 0;
  const double step = (to - from) / (2 * halves);
  double sum = f(from) + f(to);
  for (int i = 1; i < 2 * halves; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(from + i * step);
  return sum * step / 3;
}

// Integrates f(x) cos(theta + x) over the lit part of -half..half; half <= pi, 0 <= theta <= pi.
template <class F>
double over_lit_part(const F& f, double theta, double half) {
  const auto light = [&](double x) { return f(x) * std::cos(theta + x); };
  // Both ends of the lit half of the circle, the second reached around the back.
  return simpson(light, std::max(-half, -pi / 2 - theta), std::min(half, pi / 2 - theta)) +
         simpson(light, std::max(-half, 3 * pi / 2 - theta), half);
}

// The share of a normalised Gaussian of one dimension below x.
double gaussian_below(double x, double sigma) { return std::erfc(-x / (sigma * std::numbers::sqrt2)) / 2; }

double line_spread(double x_mm, double sigma_mm) {
  const double z = x_mm / sigma_mm;
  return std::exp(-z * z / 2) / (sigma_mm * std::sqrt(2 * pi));
}

struct Share {
  double light = 0, whole = 0;
};

// Along an arc of radius r, up to `bound` mm on either side.
Share share_of_arc(double theta, double r_mm, double sigma_mm, double bound_mm) {
  const double reach_mm = std::min(bound_mm, wide * sigma_mm), half = reach_mm / r_mm;
  const Share all{.whole = 1 - 2 * gaussian_below(-reach_mm, sigma_mm)};
  if (theta - half >= pi / 2 && theta + half <= 3 * pi / 2) return all;
  if (theta + half <= pi / 2 && reach_mm == wide * sigma_mm) {
    // All of it is lit: the transform of a Gaussian.
    const double angle = sigma_mm / r_mm;
    return {.light = std::cos(theta) * std::exp(-angle * angle / 2), .whole = 1};
  }
  const auto density = [&](double x) { return r_mm * line_spread(r_mm * x, sigma_mm); };
  return {.light = over_lit_part(density, theta, half), .whole = all.whole};
}

// Along a ring of radius r, with the Gaussian of two dimensions over the chord.
Share share_of_ring(double theta, double r_mm, double sigma_mm) {
  const double half = 2 * std::asin(std::min(1.0, wide * sigma_mm / (2 * r_mm)));
  const auto density = [&](double x) {
    const double chord_mm = 2 * r_mm * std::sin(x / 2);
    return std::exp(-chord_mm * chord_mm / (2 * sigma_mm * sigma_mm)) / (2 * pi * sigma_mm * sigma_mm);
  };
  return {.light = over_lit_part(density, theta, half), .whole = simpson(density, -half, half)};
}

// share_of(theta, r_mm, sigma_mm): of one Gaussian.
template <class ShareOf>
Rgb integrated(const ScatterProfile& profile, double cosine, double curvature_per_mm,
               const ShareOf& share_of) {
  const double theta = std::acos(std::clamp(cosine, -1.0, 1.0)), facing = std::max(cosine, 0.0);
  Rgb light{facing, facing, facing};
  if (curvature_per_mm <= 0) return light;

  Rgb sum{}, whole{};
  for (const Gaussian& term : profile.terms) {
    const Share share = share_of(theta, 1 / curvature_per_mm, std::sqrt(term.variance_mm2));
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += term.weight[c] * share.light;
      whole[c] += term.weight[c] * share.whole;
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
    if (whole[c] > 0) light[c] = sum[c] / whole[c];
  return light;
}

}  // namespace

Rgb lit_arc(const ScatterProfile& profile, double cosine, double curvature_per_mm) {
  const double widest_mm = std::sqrt(profile.max_variance_mm2());
  return integrated(profile, cosine, curvature_per_mm, [&](double theta, double r_mm, double sigma_mm) {
    return share_of_arc(theta, r_mm, sigma_mm, std::min(pi * r_mm, 4 * widest_mm));
  });
}

Rgb lit_ring(const ScatterProfile& profile, double cosine, double curvature_per_mm) {
  return integrated(profile, cosine, curvature_per_mm, share_of_ring);
}

Rgb lit_edge(const ScatterProfile& profile, double x_mm) {
  Rgb light{}, whole{};
  for (const Gaussian& term : profile.terms)
    for (std::size_t c = 0; c < 3; ++c) {
      light[c] += term.weight[c] * gaussian_below(x_mm, std::sqrt(term.variance_mm2));
      whole[c] += term.weight[c];
    }
  for (std::size_t c = 0; c < 3; ++c) light[c] = whole[c] > 0 ? light[c] / whole[c] : (x_mm >= 0 ? 1 : 0);
  return light;
}

double edge_in_disc(double lit_share) {
  // The part of a disc of radius 1 beside a line at -x is 1/2 + (x sqrt(1 - x^2) + asin x) / pi.
  double low = -1, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double x = (low + high) / 2, share = 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / pi;
    (share < lit_share ? low : high) = x;
  }
  return (low + high) / 2;
}

double shadow_filter_mm(const ScatterProfile& profile) { return 4 * std::sqrt(profile.max_variance_mm2()); }

LightTable lit_table(const ScatterProfile& profile, int columns, int rows, bool ring) {
  LightTable table{.columns = columns, .rows = rows, .light = {}};
  table.light.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  parallel_for(static_cast<std::size_t>(rows), [&](std::size_t row) {
    const double v = static_cast<double>(row) / (rows - 1), curvature = most_curvature_per_mm * v * v;
    for (int i = 0; i < columns; ++i) {
      const double cosine = -1 + 2.0 * i / (columns - 1);
      Rgb light = ring ? lit_ring(profile, cosine, curvature) : lit_arc(profile, cosine, curvature);
      for (double& value : light) value -= std::max(cosine, 0.0);
      table.light[row * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)] = light;
    }
  });
  return table;
}

namespace {

// lit_edge(), but 0 and 1 from the border of the filter on, beyond which no edge is known.
Rgb lit_within_filter(const ScatterProfile& profile, double x_mm) {
  const double border_mm = shadow_filter_mm(profile) / 2;
  const Rgb least = lit_edge(profile, -border_mm), most = lit_edge(profile, border_mm);
  Rgb light = lit_edge(profile, x_mm);
  for (std::size_t c = 0; c < 3; ++c)
    if (most[c] > least[c]) light[c] = std::clamp((light[c] - least[c]) / (most[c] - least[c]), 0.0, 1.0);
  return light;
}

}  // namespace

LightTable edge_table(const ScatterProfile& profile, int columns) {
  LightTable table{.columns = columns, .rows = 1, .light = {}};
  for (int i = 0; i < columns; ++i) {
    const double t = -1 + 2.0 * i / (columns - 1);
    table.light.push_back(lit_within_filter(profile, t * std::abs(t) * shadow_filter_mm(profile) / 2));
  }
  return table;
}

LightTable shadow_table(const ScatterProfile& profile, int columns, int rows) {
  LightTable table{.columns = columns, .rows = rows, .light = {}};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      // On the surface the filter is wider than across the light.
      const double cosine = (j + 1.0) / rows, x_mm = edge_in_disc(static_cast<double>(i) / (columns - 1)) *
                                                     shadow_filter_mm(profile) / (2 * cosine);
      table.light.push_back(lit_within_filter(profile, x_mm));
    }
  return table;
}

}  // namespace dermis::gaussians
