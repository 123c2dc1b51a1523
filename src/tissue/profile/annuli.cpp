// SPDX-License-Identifier: MIT
#include "tissue/profile/annuli.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/core/assert.h"

namespace dermis::profile {

using std::numbers::pi;

Annuli::Annuli(std::vector<double> edges_mm, std::vector<double> energies)
    : edges_mm_(std::move(edges_mm)), energies_(std::move(energies)) {
  DERMIS_ASSERT_EQ(edges_mm_.size(), energies_.size() + 1);
  cumulative_.assign(edges_mm_.size(), 0.0);
  for (std::size_t i = 0; i < energies_.size(); ++i) {
    DERMIS_ASSERT_LT(edges_mm_[i], edges_mm_[i + 1]);
    cumulative_[i + 1] = cumulative_[i] + energies_[i];
  }
}

double Annuli::density_per_mm2(std::size_t i) const {
  return energies_[i] / (pi * (edges_mm_[i + 1] * edges_mm_[i + 1] - edges_mm_[i] * edges_mm_[i]));
}

double Annuli::within(double radius_mm) const {
  if (energies_.empty() || !(radius_mm > 0)) return 0;
  const auto above = std::upper_bound(edges_mm_.begin(), edges_mm_.end(), radius_mm);
  if (above == edges_mm_.end()) return total();
  const std::size_t i = static_cast<std::size_t>(above - edges_mm_.begin()) - 1;
  return cumulative_[i] + density_per_mm2(i) * pi * (radius_mm * radius_mm - edges_mm_[i] * edges_mm_[i]);
}

double Annuli::quantile(double p) const {
  if (energies_.empty()) return 0;
  const double wanted = std::clamp(p, 0.0, 1.0) * total();
  for (std::size_t i = 0; i < energies_.size(); ++i) {
    if (cumulative_[i + 1] < wanted || energies_[i] <= 0) continue;
    const double part = (wanted - cumulative_[i]) / energies_[i];
    const double r0 = edges_mm_[i], r1 = edges_mm_[i + 1];
    return std::sqrt(r0 * r0 + std::clamp(part, 0.0, 1.0) * (r1 * r1 - r0 * r0));
  }
  return edges_mm_.back();
}

double Annuli::hankel(double k_per_mm) const {
  const double k = std::abs(k_per_mm);
  if (k * (edges_mm_.empty() ? 0 : edges_mm_.back()) < 1e-9) return total();
  double sum = 0;
  for (std::size_t i = 0; i < energies_.size(); ++i) {
    const double r0 = edges_mm_[i], r1 = edges_mm_[i + 1];
    // Ring i adds E_i 2 [r J1(k r)] / (k (r1^2 - r0^2)), [ ] the difference between its edges. For k r << 1
    // that difference cancels; there the mean of J0(x) = 1 - x^2/4 over the ring is exact enough.
    const double mean = k * r1 < 1e-3
                            ? 1 - k * k * (r0 * r0 + r1 * r1) / 8
                            : 2 * (r1 * ::j1(k * r1) - r0 * ::j1(k * r0)) / (k * (r1 * r1 - r0 * r0));
    sum += energies_[i] * mean;
  }
  return sum;
}

std::vector<double> log_edges(double inner_mm, double outer_mm, int per_decade) {
  DERMIS_ASSERT(inner_mm > 0 && outer_mm > inner_mm && per_decade > 0);
  const int count = std::max(1, static_cast<int>(std::ceil(std::log10(outer_mm / inner_mm) * per_decade)));
  std::vector<double> edges{0};
  for (int i = 0; i <= count; ++i)
    edges.push_back(inner_mm * std::pow(outer_mm / inner_mm, static_cast<double>(i) / count));
  return edges;
}

}  // namespace dermis::profile
