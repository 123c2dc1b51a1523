// SPDX-License-Identifier: MIT
#include "viewer/model/pace.h"

#include <algorithm>

namespace dermis::viewer {

void Pace::drew(double ms) {
  // Smaller at once, larger only when it has paid several times: each size makes a plan of its own.
  if (ms > pace_ms && level_ + 1 < divisors.size()) {
    ++level_;
    quick_ = 0;
    return;
  }
  const double finer = static_cast<double>(divisors[level_]) / divisors[level_ == 0 ? 0 : level_ - 1];
  const bool has_time = ms * finer * finer < pace_ms / 2;
  quick_ = has_time ? quick_ + 1 : 0;
  if (quick_ < 8 || level_ == 0) return;
  --level_;
  quick_ = 0;
}

RenderSettings Pace::settings(const RenderSettings& full) const {
  const int by = divisor();
  if (by == 1) return full;

  RenderSettings small = full;
  small.output.width = std::max(full.output.width / by, 1);
  small.output.height = std::max(full.output.height / by, 1);
  small.quality.samples = 1;
  // The same at every level: seams are prepared for each size of the maps, which takes seconds.
  small.quality.map_size = std::min(full.quality.map_size, moving_map_size);
  small.quality.shadow_size = std::min(full.quality.shadow_size, 2 * moving_map_size);
  return small;
}

}  // namespace dermis::viewer
