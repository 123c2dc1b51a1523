// SPDX-License-Identifier: MIT
// Frames that are drawn in turns: those that fit in memory stay prepared, the others are made anew each time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dermis/renderer.h"

namespace dermis::api {

/// Half of the memory of the device of this name, 2 GiB if it does not say. The other half is for the scene
/// and for one frame that is on its way.
std::uint64_t half_of_device(const std::string& device);

class HeldFrames {
 public:
  /// Keeps references to both. `most_bytes`: what frames may hold while they wait, given the device's name.
  HeldFrames(Renderer& renderer, const std::function<std::uint64_t(const std::string&)>& most_bytes)
      : renderer_(&renderer), most_bytes_(&most_bytes) {}

  /// Adds a frame; scenes are values. Returns its number.
  std::size_t add(const Scene& scene, const RenderSettings& settings);
  std::size_t size() const { return entries_.size(); }

  /// Draws the first frame: warms up, counts, and is the picture. Keeps the frame if there is memory for it.
  Picture warm_up(std::size_t i);

  /// Draws a frame and returns its time, ms; `passes`, if given, receives those of this frame. Throws as
  /// Renderer::prepare().
  double draw(std::size_t i, std::vector<PassStatistics>* passes = nullptr);

 private:
  struct Entry {
    Scene scene;
    RenderSettings settings;
    std::optional<PreparedFrame> frame;
  };
  PreparedFrame& prepared(Entry& entry);

  Renderer* renderer_;
  const std::function<std::uint64_t(const std::string&)>* most_bytes_;
  bool none_waits_ = false;
  std::vector<Entry> entries_;
};

}  // namespace dermis::api
