// SPDX-License-Identifier: MIT
#include "profile/radial.h"

#include <cmath>
#include <numbers>

#include "optics/quadrature.h"

namespace dermis::profile {

using std::numbers::pi;

const Annuli& RadialProfile::annuli() const {
  std::call_once(once_, [this] {
    std::vector<double> edges = log_edges(1e-4 * inner_mm(), 60 * outer_mm(), 46);
    std::vector<double> energies;
    const double half = std::log(edges[2] / edges[1]) / 2;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      if (i == 0) {  // so small that R is either flat or 1/r there
        const double r = edges[1];
        energies.push_back((has_pole() ? 2 : 1) * pi * r * r * at(r));
        continue;
      }
      double sum = 0;  // two-point Gauss in log r: r dr = r^2 d(log r)
      for (const double side : {-1.0, 1.0}) {
        const double r = std::sqrt(edges[i] * edges[i + 1]) * std::exp(side * half / std::numbers::sqrt3);
        sum += 2 * pi * r * r * at(r) * half;
      }
      energies.push_back(sum);
    }
    annuli_ = Annuli(std::move(edges), std::move(energies));
  });
  return annuli_;
}

double inverse_hankel(const RadialProfile& profile, double radius_mm) {
  const double k_max = 45 / profile.inner_mm();
  if (radius_mm < profile.inner_mm()) {
    // J0 turns at most a few times before R^ has died: the trapezoid rule in log k is exponentially accurate.
    constexpr double step = 0.02;
    double sum = 0;
    for (double k = 1e-6 / profile.outer_mm(); k < k_max; k *= std::exp(step))
      sum += profile.hankel(k) * ::j0(k * radius_mm) * k * k * step;
    return sum / (2 * pi);
  }
  const auto integrand = [&](double x) { return x / radius_mm > k_max ? 0.0 : profile.hankel(x / radius_mm) * x; };
  return optics::bessel_j0_integral(integrand) / (2 * pi * radius_mm * radius_mm);
}

}  // namespace dermis::profile
