// SPDX-License-Identifier: MIT
#include "tissue/optics/quadrature.h"

#include <cmath>
#include <numbers>

#include "base/core/assert.h"

namespace dermis::optics {
namespace {

using std::numbers::pi;

/// Returns zero number k (from 1) of J0: McMahon's expansion, then Newton (J0' = -J1).
double bessel_j0_zero(int k) {
  const double b = (k - 0.25) * pi;
  double x = b + 1 / (8 * b) - 31 / (384 * b * b * b);
  for (int step = 0; step < 4; ++step) x += ::j0(x) / ::j1(x);
  return x;
}

/// Returns nodes and weights of [O05] eq. 5.2 with step h: zeros of J0, bent by psi(t) = t tanh(pi/2 sinh t),
/// so that the oscillation dies out double-exponentially. Weights include J0 at the node.
std::vector<Node> ogata_rule(double h, int count) {
  std::vector<Node> rule;
  for (int k = 1; k <= count; ++k) {
    const double zero = bessel_j0_zero(k);
    const double t = h * zero / pi;
    const double inner = pi / 2 * std::sinh(t);
    const double psi = t * std::tanh(inner);
    const double sech = inner < 300 ? 1 / std::cosh(inner) : 0;
    const double slope = std::tanh(inner) + t * pi / 2 * std::cosh(t) * sech * sech;
    const double x = pi / h * psi;
    const double weight = pi * (::y0(zero) / ::j1(zero)) * ::j0(x) * slope;
    // Near convergence the nodes coincide with zeros of J0, and only rounding is left.
    if (std::abs(pi / h * t - x) < 1e-13 * x) break;
    rule.push_back({x, weight});
  }
  return rule;
}

}  // namespace

std::vector<Node> gauss_legendre(int count, double low, double high) {
  DERMIS_ASSERT(count >= 1 && count <= 512);
  std::vector<Node> rule(count);
  const double half = (high - low) / 2, middle = (high + low) / 2;

  for (int i = 0; i < count; ++i) {
    // A close first guess, then Newton on the Legendre polynomial of degree `count`.
    double x = std::cos(pi * (i + 0.75) / (count + 0.5));
    double slope = 1;
    for (int step = 0; step < 100; ++step) {  // Newton on the Legendre polynomial of degree `count`
      double p0 = 1, p1 = x;
      for (int n = 2; n <= count; ++n) {
        const double p2 = ((2 * n - 1) * x * p1 - (n - 1) * p0) / n;
        p0 = p1;
        p1 = p2;
      }

      slope = count * (x * p1 - p0) / (x * x - 1);
      const double change = p1 / slope;
      x -= change;
      if (std::abs(change) < 1e-15) break;
    }

    rule[i] = {middle - half * x, half * 2 / ((1 - x * x) * slope * slope)};
  }
  return rule;
}

double bessel_j0_integral(const std::function<double(double)>& f) {
  static const std::vector<Node> rule = ogata_rule(0.005, 1200);
  double sum = 0;
  for (const Node& node : rule) sum += node.weight * f(node.x);
  return sum;
}

}  // namespace dermis::optics
