// SPDX-License-Identifier: MIT
// The frames of one cell, which are drawn in turns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "api/compare/held_frames.h"
#include "cli/bench/result.h"
#include "dermis/renderer.h"

namespace dermis::cli::bench {

class Contest {
 public:
  /// `most_bytes`: as HeldFrames has it; it must outlive the contest, as renderer and scene must.
  Contest(Renderer& renderer, const Scene& scene, std::vector<Variant> variants,
          const std::function<std::uint64_t(const std::string&)>& most_bytes);

  std::size_t size() const { return entries_.size(); }
  const Measured& measured(std::size_t i) const { return entries_[i].measured; }

  /// The first frame of a variant: makes what it needs, counts, and is the picture.
  Picture warm_up(std::size_t i);
  /// Draws rounds and throws them away until the device had time to come up to its clocks, or is to stop.
  void wake_the_device(const std::function<bool()>& stopped);
  /// Draws a frame that counts.
  void draw(std::size_t i);

  /// Returns what was measured; the contest is over.
  std::vector<Measured> finish();

 private:
  struct Entry {
    Measured measured;
    std::vector<std::vector<PassStatistics>> passes;  ///< of each round
  };

  api::HeldFrames frames_;
  std::vector<Entry> entries_;
};

}  // namespace dermis::cli::bench
