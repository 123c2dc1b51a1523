// SPDX-License-Identifier: MIT
/// What shadow maps show that last from frame to frame, so that they are drawn only when that changes.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "frame/graph.h"

namespace dermis::passes {

class KeptShadows {
 public:
  /// Returns whether a head's layers of a map, from `first_layer` on, are to be drawn, and counts on it that
  /// they are. `version`: Instance::shadow_version.
  bool must_draw(frame::TextureId map, std::uint32_t first_layer, std::uint32_t layers,
                 std::uint64_t version) {
    std::uint64_t& shown = shown_[{map.index, first_layer}];
    if (version != 0 && shown == version) return false;
    shown = version;
    drawn_ += layers;
    return true;
  }

  /// Returns how many layers have been drawn, in all frames.
  std::uint64_t drawn() const { return drawn_; }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> shown_;  // by map and first layer
  std::uint64_t drawn_ = 0;
};

}  // namespace dermis::passes
