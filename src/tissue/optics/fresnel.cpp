// SPDX-License-Identifier: MIT
#include "tissue/optics/fresnel.h"

#include <algorithm>
#include <cmath>

#include "base/core/assert.h"
#include "tissue/optics/quadrature.h"

namespace dermis::optics {
namespace {

/// Returns Int_0^1 F(mu, n) mu^power dmu. Past the critical angle F = 1. At it F has a square-root kink,
/// which the substitution mu = mu_c + (1 - mu_c) t^2 removes.
double fresnel_moment(double n, int power) {
  static const std::vector<Node> rule = gauss_legendre(64, 0, 1);
  const double mu_critical = n > 1 ? std::sqrt(1 - 1 / (n * n)) : 0;
  double sum = std::pow(mu_critical, power + 1) / (power + 1);
  for (const Node& node : rule) {
    const double mu = mu_critical + (1 - mu_critical) * node.x * node.x;
    sum += node.weight * fresnel(mu, n) * std::pow(mu, power) * 2 * node.x * (1 - mu_critical);
  }
  return sum;
}

}  // namespace

double fresnel(double cos_incident, double n) {
  const double ci = std::clamp(cos_incident, 0.0, 1.0);
  const double sin2_t = n * n * (1 - ci * ci);
  if (sin2_t >= 1) return 1;

  // F = (r_par^2 + r_perp^2) / 2 with Snell's sin_t = n sin_i.
  const double ct = std::sqrt(1 - sin2_t);
  if (n * ci + ct == 0 || ci + n * ct == 0) return 1;
  const double perpendicular = (n * ci - ct) / (n * ci + ct);
  const double parallel = (ci - n * ct) / (ci + n * ct);
  return (perpendicular * perpendicular + parallel * parallel) / 2;
}

double fresnel_diffuse_polynomial(double n) {
  DERMIS_ASSERT(n > 0);
  if (n == 1) return 0;
  if (n > 1) return -1.440 / (n * n) + 0.710 / n + 0.668 + 0.0636 * n;
  return -0.4399 + 0.7099 / n - 0.3319 / (n * n) + 0.0636 / (n * n * n);
}

double fresnel_moment_2c1(double n) { return n == 1 ? 0 : 2 * fresnel_moment(n, 1); }
double fresnel_moment_3c2(double n) { return n == 1 ? 0 : 3 * fresnel_moment(n, 2); }

double boundary_factor_classical(double n) {
  const double fdr = fresnel_diffuse_polynomial(n);
  return (1 + fdr) / (1 - fdr);
}

}  // namespace dermis::optics
