// SPDX-License-Identifier: MIT
#include "tissue/gaussians/screen_kernels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "base/core/assert.h"

namespace dermis::gaussians {
namespace {

using std::numbers::pi;

// Offsets of [JZJ15]: denser towards the middle, a = R (o / R)^2 with the sign of o.
std::vector<double> offsets(int taps, double reach) {
  DERMIS_ASSERT_LE(least_line_taps, taps);
  DERMIS_ASSERT_LE(taps, most_line_taps);
  DERMIS_ASSERT_EQ(taps % 2, 1);

  std::vector<double> at;
  for (int i = 0; i < taps; ++i) {
    const double o = 2.0 * i / (taps - 1) - 1;
    at.push_back(reach * std::copysign(o * o, o));
  }
  return at;
}

// Divides by the sums, and puts the middle tap first.
std::vector<LineTap> finished(std::vector<LineTap> kernel) {
  const std::size_t middle = kernel.size() / 2;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (const LineTap& tap : kernel) sum += tap.weight[c];
    if (sum > 0)
      for (LineTap& tap : kernel) tap.weight[c] /= sum;
    else
      kernel[middle].weight[c] = 1;
  }
  std::rotate(kernel.begin(), kernel.begin() + static_cast<std::ptrdiff_t>(middle),
              kernel.begin() + static_cast<std::ptrdiff_t>(middle) + 1);
  return kernel;
}

// The share of a Gaussian of one dimension below x.
double below(double x, double sigma) { return std::erfc(-x / (sigma * std::numbers::sqrt2)) / 2; }

// Returns x >= 0 where a growing function, 0 at 0, has a value, by bisection to the last bits.
double inverse(const std::function<double(double)>& grows, double value, double high) {
  while (grows(high) < value) high *= 2;
  double low = 0;
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2;
    (grows(middle) < value ? low : high) = middle;
  }
  return (low + high) / 2;
}

std::size_t widest_channel(const Rgb& variance_mm2) {
  return static_cast<std::size_t>(std::max_element(variance_mm2.begin(), variance_mm2.end()) -
                                  variance_mm2.begin());
}

Rgb variances_mm2(const ScatterProfile& profile) {
  Rgb variance{};
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0, weight = 0;
    for (const Gaussian& term : profile.terms) {
      sum += term.weight[c] * term.variance_mm2;
      weight += term.weight[c];
    }
    if (weight > 0) variance[c] = sum / weight;
  }
  return variance;
}

std::vector<DiscTap> taps_at(int taps, const std::function<double(double)>& radius_mm,
                             const std::function<double(double)>& density_per_mm2) {
  std::vector<DiscTap> all;
  for (int i = 0; i < taps; ++i) {
    const double turns = i * (std::numbers::phi - 1), angle = 2 * pi * (turns - std::floor(turns));
    const double r = radius_mm((i + 0.5) / taps);
    all.push_back({.x_mm = r * std::cos(angle),
                   .y_mm = r * std::sin(angle),
                   .radius_mm = r,
                   .per_density_mm2 = 1 / density_per_mm2(r)});
  }
  return all;
}

}  // namespace

std::vector<LineTap> published_line_kernel(int taps) {
  constexpr Rgb strength{0.48, 0.41, 0.28}, falloff{1, 0.37, 0.3};
  struct Term {
    double weight, variance_mm2;
  };
  // The red weights of the six Gaussians of d'Eon and Luebke but the narrowest, for all channels: colour
  // comes from the falloff.
  constexpr Term terms[] = {{0.1, 0.0484}, {0.118, 0.187}, {0.113, 0.567}, {0.358, 1.99}, {0.078, 7.41}};
  constexpr double their_pi = 3.14;

  const auto profile = [&](double a, double width) {
    const double x = a / (0.001 + width);
    double sum = 0;
    for (const Term& t : terms)
      sum += t.weight * std::exp(-x * x / (2 * t.variance_mm2)) / (2 * their_pi * t.variance_mm2);
    return sum;
  };

  const std::vector<double> at = offsets(taps, taps > 20 ? 3 : 2);
  std::vector<LineTap> kernel;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double gap_before = i > 0 ? at[i] - at[i - 1] : 0,
                 gap_after = i + 1 < at.size() ? at[i + 1] - at[i] : 0;
    LineTap tap{.offset = at[i]};
    for (std::size_t c = 0; c < 3; ++c)
      tap.weight[c] = (gap_before + gap_after) / 2 * profile(at[i], falloff[c]);
    kernel.push_back(tap);
  }
  kernel = finished(std::move(kernel));

  for (std::size_t c = 0; c < 3; ++c)
    for (LineTap& tap : kernel)
      tap.weight[c] =
          &tap == kernel.data() ? 1 - strength[c] * (1 - tap.weight[c]) : strength[c] * tap.weight[c];
  return kernel;
}

double line_kernel_reach_mm(const ScatterProfile& profile) {
  return 7.5 * std::sqrt(profile.max_variance_mm2() / 7.41);
}

std::vector<LineTap> line_spread_kernel(const ScatterProfile& profile, int taps) {
  const std::vector<double> at = offsets(taps, line_kernel_reach_mm(profile));
  constexpr double far = std::numeric_limits<double>::infinity();

  std::vector<LineTap> kernel;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double from = i > 0 ? (at[i - 1] + at[i]) / 2 : -far,
                 to = i + 1 < at.size() ? (at[i] + at[i + 1]) / 2 : far;
    LineTap tap{.offset = at[i]};
    for (const Gaussian& term : profile.terms) {
      const double sigma = std::sqrt(term.variance_mm2), share = below(to, sigma) - below(from, sigma);
      for (std::size_t c = 0; c < 3; ++c) tap.weight[c] += term.weight[c] * share;
    }
    kernel.push_back(tap);
  }
  return finished(std::move(kernel));
}

PartlyBlurred published_skin_gaussians() {
  return {.unblurred = {0.240516183695, 0.447403391891, 0.615796108321},
          .terms = {{0.0516500425655, {0.115857499765, 0.366176401412, 0.343917471552}},
                    {0.271928080903, {0.183619017698, 0.186420206697, 0}},
                    {2.00626388153, {0.460007298842, 0, 0.0402864201267}}}};
}

Rgb burley_distances_mm(const ScatterProfile& profile) {
  Rgb d = variances_mm2(profile);
  for (double& distance : d) distance = std::sqrt(distance / 7);
  return d;
}

double radius_of_share_mm(const ScatterProfile& profile, std::size_t channel, double share) {
  double all = 0;
  for (const Gaussian& term : profile.terms) all += term.weight[channel];
  const auto within = [&](double r) {
    double sum = 0;
    for (const Gaussian& term : profile.terms)
      sum -= term.weight[channel] * std::expm1(-r * r / (2 * term.variance_mm2));
    return sum / all;
  };
  return inverse(within, share, std::sqrt(profile.max_variance_mm2()));
}

std::size_t widest_channel(const ScatterProfile& profile) { return widest_channel(variances_mm2(profile)); }

double disc_reach_mm(const ScatterProfile& profile, double share) {
  return radius_of_share_mm(profile, widest_channel(profile), share);
}

double burley_radius_of_share(double share) {
  // [CB15]: the share within r is 1 - e^(-r) / 4 - 3 e^(-r/3) / 4.
  return inverse([](double r) { return -std::expm1(-r) / 4 - 3 * std::expm1(-r / 3) / 4; }, share, 1);
}

std::vector<DiscTap> disc_taps(const ScatterProfile& profile, int taps) {
  const std::size_t widest = widest_channel(profile);
  double all = 0;
  for (const Gaussian& term : profile.terms) all += term.weight[widest];
  const auto density = [&](double r) {
    double sum = 0;
    for (const Gaussian& term : profile.terms)
      sum += term.weight[widest] * std::exp(-r * r / (2 * term.variance_mm2)) / (2 * pi * term.variance_mm2);
    return sum / all;
  };
  return taps_at(
      taps, [&](double share) { return radius_of_share_mm(profile, widest, share); }, density);
}

std::vector<DiscTap> burley_disc_taps(const Rgb& distances_mm, int taps) {
  const double d = distances_mm[widest_channel(distances_mm)];
  const auto density = [&](double r) {
    return (std::exp(-r / d) + std::exp(-r / (3 * d))) / (8 * pi * d * r);
  };
  return taps_at(
      taps, [&](double share) { return d * burley_radius_of_share(share); }, density);
}

}  // namespace dermis::gaussians
