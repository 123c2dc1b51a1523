// SPDX-License-Identifier: MIT
// Exact reflectances of a half-space without a boundary, which scatters isotropically with albedo 0..1.
// Based on: [C60] Chandrasekhar: Radiative Transfer. Dover 1960, ch. 5
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tissue/optics/quadrature.h"

namespace dermis::optics {

struct HFunction {
  std::vector<Node> rule;
  std::vector<double> h;
};

inline HFunction solve_h(double albedo) {
  HFunction out{gauss_legendre(200, 0, 1), {}};
  out.h.assign(out.rule.size(), 1.0);
  const double root = std::sqrt(1 - albedo);

  // Iterates 1/H(x) = sqrt(1-a) + a/2 Int_0^1 y H(y) / (x + y) dy, [C60] ch. 5.
  for (int step = 0; step < 20000; ++step) {
    double change = 0;
    std::vector<double> next(out.h.size());
    for (std::size_t i = 0; i < out.h.size(); ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < out.h.size(); ++j)
        sum += out.rule[j].weight * out.rule[j].x * out.h[j] / (out.rule[i].x + out.rule[j].x);
      // the mean of both: plain substitution oscillates without absorption
      next[i] = (1 / (root + albedo / 2 * sum) + out.h[i]) / 2;
      change = std::max(change, std::abs(next[i] - out.h[i]));
    }

    out.h = std::move(next);
    if (change < 1e-12) break;
  }

  return out;
}

/// Returns H(mu) of [C60], mu 0..1; within 1e-12 on 200 Gauss points.
inline double chandrasekhar_h(double albedo, double mu) {
  const HFunction f = solve_h(albedo);
  double sum = 0;
  for (std::size_t j = 0; j < f.h.size(); ++j)
    sum += f.rule[j].weight * f.rule[j].x * f.h[j] / (mu + f.rule[j].x);
  return 1 / (std::sqrt(1 - albedo) + albedo / 2 * sum);
}

/// Returns the reflectance (0..1) for a perpendicular beam: 1 - sqrt(1-a) H(1).
inline double exact_reflectance_perpendicular(double albedo) {
  return 1 - std::sqrt(1 - albedo) * chandrasekhar_h(albedo, 1);
}

/// Returns that for diffuse light: 1 - 2 sqrt(1-a) Int_0^1 mu H(mu) dmu.
inline double exact_reflectance_diffuse(double albedo) {
  const HFunction f = solve_h(albedo);
  double sum = 0;
  for (std::size_t j = 0; j < f.h.size(); ++j) sum += f.rule[j].weight * f.rule[j].x * f.h[j];
  return 1 - 2 * std::sqrt(1 - albedo) * sum;
}

}  // namespace dermis::optics
