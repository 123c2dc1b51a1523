// SPDX-License-Identifier: MIT
#include "tissue/gaussians/one.h"

namespace dermis::gaussians {

ScatterProfile one_gaussian(const ScatterProfile& sum) {
  double moment_mm2 = 0, weight = 0;
  for (const Gaussian& term : sum.terms)
    for (const double w : term.weight) {
      moment_mm2 += w * term.variance_mm2;
      weight += w;
    }
  ScatterProfile one = sum;
  one.name += ", one Gaussian";
  one.error_percent = {};
  one.terms = {{.variance_mm2 = moment_mm2 / weight, .weight = {1, 1, 1}}};
  return one;
}

}  // namespace dermis::gaussians
