// SPDX-License-Identifier: MIT
/// Versions of the contents of maps that last from frame to frame, so that they are drawn only when these
/// change.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "frame/graph.h"

namespace dermis::passes {

class KeptMaps {
 public:
  /// Returns whether `layers` layers (or one square) of a map, from `place` on, are to be drawn, and counts
  /// on it that they are. `version`: of what they show; 0: it may change unseen.
  bool must_draw(frame::TextureId map, std::uint32_t place, std::uint32_t layers, std::uint64_t version) {
    std::uint64_t& shown = shown_[{map.index, place}];
    if (version != 0 && shown == version) return false;
    shown = version;
    drawn_ += layers;
    return true;
  }

  /// Returns how many have been drawn, in all frames.
  std::uint64_t drawn() const { return drawn_; }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> shown_;  // by map and place
  std::uint64_t drawn_ = 0;
};

}  // namespace dermis::passes
