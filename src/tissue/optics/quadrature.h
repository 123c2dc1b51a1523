// SPDX-License-Identifier: MIT
// Quadrature for integrals without a closed form.
// Based on: [O05] Ogata: A Numerical Integration Formula Based on the Bessel Functions.
//           Publ. RIMS 41, 2005, eq. 5.2
#pragma once

#include <functional>
#include <vector>

namespace dermis::optics {

struct Node {
  double x = 0;
  double weight = 0;
};

/// Returns the Gauss-Legendre rule Int_low^high f(x) dx = Sum_i w_i f(x_i) with `count` nodes (1 to 512) in
/// rising order; low < high. Exact for polynomials of degree 2 count - 1. Abramowitz and Stegun 25.4.29.
std::vector<Node> gauss_legendre(int count, double low, double high);

/// Returns Int_0^inf f(x) J0(x) dx by [O05]. f is smooth on x > 0 and grows at most moderately; absolute
/// accuracy is about 1e-10 of the largest |f(x) x|.
double bessel_j0_integral(const std::function<double(double)>& f);

}  // namespace dermis::optics
