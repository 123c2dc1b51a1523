// SPDX-License-Identifier: MIT
#include "tissue/profile/radial.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tissue/optics/quadrature.h"

namespace dermis::profile {

using std::numbers::pi;

namespace {

/// Returns the energy between two radii, low > 0: two-point Gauss rule in log r on each smooth piece,
/// r dr = r^2 d(log r).
double ring_energy(const RadialProfile& profile, double low, double high) {
  double sum = 0;
  const auto add_piece = [&](double from, double to) {
    const double half = std::log(to / from) / 2;
    for (const double side : {-1.0, 1.0}) {
      const double r = std::sqrt(from * to) * std::exp(side * half / std::numbers::sqrt3);
      sum += 2 * pi * r * r * profile.at(r) * half;
    }
  };
  const std::span<const double> breaks = profile.break_points_mm();
  for (auto next = std::upper_bound(breaks.begin(), breaks.end(), low); next != breaks.end() && *next < high;
       ++next) {
    add_piece(low, *next);
    low = *next;
  }
  add_piece(low, high);
  return sum;
}

}  // namespace

const Annuli& RadialProfile::annuli() const {
  std::call_once(once_, [this] {
    std::vector<double> edges = log_edges(1e-4 * inner_mm(), 60 * outer_mm(), 46);
    std::vector<double> energies;
    const double core_mm = edges[1];  // so small that R is either constant or 1/r there
    energies.push_back((has_pole() ? 2 : 1) * pi * core_mm * core_mm * at(core_mm));
    for (std::size_t i = 1; i + 1 < edges.size(); ++i)
      energies.push_back(ring_energy(*this, edges[i], edges[i + 1]));
    annuli_ = Annuli(std::move(edges), std::move(energies));
  });
  return annuli_;
}

double inverse_hankel(const RadialProfile& profile, double radius_mm) {
  // R(r) = Int_0^inf R^(k) J0(k r) k dk / (2 pi).
  const double k_max = 45 / profile.inner_mm();
  if (radius_mm < profile.inner_mm()) {
    // J0 oscillates at most a few times before R^ vanishes: the trapezoid rule in log k converges
    // exponentially.
    constexpr double step = 0.02;
    double sum = 0;
    for (double k = 1e-6 / profile.outer_mm(); k < k_max; k *= std::exp(step))
      sum += profile.hankel(k) * ::j0(k * radius_mm) * k * k * step;
    return sum / (2 * pi);
  }

  // With x = k r: Int R^(x/r) x J0(x) dx / (2 pi r^2).
  const auto integrand = [&](double x) {
    return x / radius_mm > k_max ? 0.0 : profile.hankel(x / radius_mm) * x;
  };
  return optics::bessel_j0_integral(integrand) / (2 * pi * radius_mm * radius_mm);
}

}  // namespace dermis::profile
