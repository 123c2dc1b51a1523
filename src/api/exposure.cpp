// SPDX-License-Identifier: MIT
#include "api/exposure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dermis::api {

std::optional<double> mean_skin_luminance(std::span<const float> rgba) {
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const double alpha = std::clamp(static_cast<double>(rgba[i + 3]), 0.0, 1.0);
    if (!(alpha > 0)) continue;
    const double luminance = 0.2126 * rgba[i] + 0.7152 * rgba[i + 1] + 0.0722 * rgba[i + 2];
    sum += alpha * luminance;
    weight += alpha;
  }

  if (weight <= 0) return std::nullopt;
  return sum / weight;
}

std::optional<double> choose_exposure(const std::function<std::optional<double>(double ev)>& mean_at) {
  constexpr double limit_ev = 64, dark_ev = 24;  // light of less than a half float's least shows at dark_ev
  constexpr double near_ev = 4;                  // half floats are as exact that many stops away
  double ev = 0;
  for (int round = 0; round < 6; ++round) {
    const std::optional<double> mean = mean_at(ev);
    if (!mean) return std::nullopt;
    if (!(*mean > 0)) {
      if (ev >= dark_ev) return std::nullopt;
      ev = dark_ev;
      continue;
    }

    const double next = std::clamp(ev + std::log2(exposed_light / *mean), -limit_ev, limit_ev);
    const bool is_near = std::abs(next - ev) <= near_ev;
    ev = next;
    if (is_near) break;
  }

  // To two decimals, so that the number that is printed gives the same picture again.
  return std::round(ev * 100) / 100;
}

}  // namespace dermis::api
