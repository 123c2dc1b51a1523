// SPDX-License-Identifier: MIT
// Light that a point source in a diffusing medium sends through a plane. Lengths
// in mm, s = sigma_tr in 1/mm.
#pragma once

#include <cmath>

namespace dermis::profile {

/// Returns z (1 + s d) e^{-s d} / d^3, d = sqrt(r^2 + z^2): 4 pi times the flux at radius r through a plane
/// at distance z from a source of unit power. Odd in z: negative for a source on the other side. Its Hankel
/// transform is 2 pi e^{-z kappa}, kappa = sqrt(s^2 + k^2).
inline double source_flux(double z, double radius, double s) {
  const double d = std::sqrt(radius * radius + z * z);
  return z * (1 + s * d) * std::exp(-s * d) / (d * d * d);
}

}  // namespace dermis::profile
