// SPDX-License-Identifier: MIT
#include "tissue/profile/thin_slab.h"

#include <algorithm>
#include <cmath>

namespace dermis::profile {
namespace {

// From 2 mean free paths on, the multipole between equal indices agrees with the transport equation within
// 0.025 (albedo 0.95 and more).
constexpr double core_thickness = 2;

// With an extinction of 1 instead of 1.5 a larger part of the beam would remain at thin_limit() than in the
// multipole, where it is 0.
constexpr double beam_extinction = 1.5;
constexpr double unscattered_extinction = 3.5;

/// Returns the diffuse reflectance that gives z_b = 2 A D: A = (1 + rho) / (1 - rho), D = 1/3.
double mirror(double z_b) {
  const double a = std::max(1.5 * z_b, 1.0);
  return (a - 1) / (a + 1);
}

struct Sides {
  double reflect, transmit;
};

/// Returns what leaves on both sides when light enters the core at the side of mirror `near`; the part
/// `unturned` of it passes the mirror `far`. With the flux u that comes back and v that arrives scattered:
///   u = R (1 + near u) + T far v,  v + unturned = T (1 + near u) + R far v.
Sides lit(const TwoFlux& core, double near, double far, double unturned) {
  const double r = core.reflect, t = core.transmit;
  const double determinant = (1 - r * near) * (1 - r * far) - t * t * near * far;
  const double u = (r * (1 - r * far) + t * far * (t - unturned)) / determinant;
  const double v = ((1 - r * near) * (t - unturned) + t * near * r) / determinant;
  return {(1 - near) * u, (1 - far) * v + unturned};
}

}  // namespace

double thin_limit(double z_b_above, double z_b_below) {
  return std::clamp(3.3 - z_b_above - z_b_below, 1.1, core_thickness);
}

TwoFlux part_of(const TwoFlux& layer, double x) {
  // [K48]: a = (1 + R^2 - T^2) / 2R, b = sqrt(a^2 - 1), and S d from T.
  const double r = layer.reflect, t = layer.transmit;
  if (r < 1e-280) return {r, std::pow(t, x)};
  const double a_less_1 = std::max((1 - r - t) * (1 - r + t) / (2 * r), 0.0);
  const double a = 1 + a_less_1, b = std::sqrt(a_less_1 * (a + 1));

  if (b < 1e-6) {  // no absorption: S d = R / T
    const double sd = r / t * x;
    return {sd / (1 + sd), 1 / (1 + sd)};
  }

  // y = b S d x; R_x = sinh y / (a sinh y + b cosh y), T_x = b / (a sinh y + b cosh y).
  const double y = std::log((1 - r / (a + b)) / t) * x;
  const double below = a * std::sinh(y) + b * std::cosh(y);
  return {std::sinh(y) / below, b / below};
}

ThinSlab::ThinSlab(const Medium& medium, double z_b_above, double z_b_below)
    : medium_(medium),
      limit_(thin_limit(z_b_above, z_b_below)),
      rho_above_(mirror(z_b_above)),
      rho_below_(mirror(z_b_below)) {
  total_ = reference(0);
}

TwoFlux ThinSlab::reference(double k) const {
  constexpr double z_b = 2.0 / 3;  // equal indices
  const TwoFlux sums = multipole_sums(std::hypot(medium_.sigma_tr, k), 1, core_thickness, z_b, z_b);
  // The multipole holds scattered light only. A small part of the unscattered light is kept, else clear
  // layers would be black.
  const double unscattered =
      (1 - medium_.reduced_albedo) * std::exp(-unscattered_extinction * core_thickness - k);
  return {medium_.reduced_albedo * sums.reflect, medium_.reduced_albedo * sums.transmit + unscattered};
}

Spectra ThinSlab::cut(const Frequency& at, double thickness) const {
  const double x = thickness / core_thickness;
  TwoFlux core = part_of(at.reference, x);
  core.reflect *= std::exp(-at.beyond);
  core.transmit *= std::exp(-x * at.beyond);
  const double total = part_of(total_, x).transmit;
  return between_mirrors(core, core.transmit * std::min(1.0, std::exp(-beam_extinction * thickness) / total));
}

Spectra ThinSlab::between_mirrors(const TwoFlux& core, double unturned) const {
  const Sides beam = lit(core, rho_above_, rho_below_, unturned);
  const Sides above = lit(core, rho_above_, rho_below_, 0), below = lit(core, rho_below_, rho_above_, 0);
  return {
      above.reflect, above.transmit, below.reflect, below.transmit, {beam.reflect, beam.transmit, unturned}};
}

Spectra ThinSlab::spectra(double k, double thickness, const Spectra& at_limit) const {
  // R and T of the reference fall like e^{-k}. Past k = 300 that is extrapolated, because T_x = T^x is still
  // large there if x is small.
  const double shown = std::min(k, 300.0);
  const Frequency at{reference(shown), k - shown};
  const Spectra here = cut(at, thickness), there = cut(at, limit_);
  const double weight = std::pow(thickness / limit_, 1.5);
  const auto joined = [&](double cut_here, double cut_there, double multipole) {
    return cut_here + weight * (multipole - cut_there);
  };
  return {joined(here.reflect_above, there.reflect_above, at_limit.reflect_above),
          joined(here.transmit_above, there.transmit_above, at_limit.transmit_above),
          joined(here.reflect_below, there.reflect_below, at_limit.reflect_below),
          joined(here.transmit_below, there.transmit_below, at_limit.transmit_below),
          {joined(here.beam.reflect, there.beam.reflect, at_limit.beam.reflect),
           joined(here.beam.transmit, there.beam.transmit, at_limit.beam.transmit),
           joined(here.beam.straight, there.beam.straight, at_limit.beam.straight)}};
}

}  // namespace dermis::profile
