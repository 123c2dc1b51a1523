// SPDX-License-Identifier: MIT
/// Draws the frames of a sequence, each as `dermis render` draws it.
#pragma once

#include <cstddef>
#include <optional>

#include "dermis/renderer.h"
#include "dermis/session.h"

namespace dermis::cli::sequence {

struct Frame {
  std::size_t number = 0;
  Picture picture;
};

/// One device, one plan and one set of pipelines for all frames. While the device draws a frame, the one
/// before it can be written. Where a session cannot draw (exposure chosen by the light, maps shown in place
/// of the picture), frames are drawn one after the other.
class Frames {
 public:
  /// `settings`: those of any frame.
  Frames(Renderer& renderer, const RenderSettings& settings);

  /// Begins a frame. Returns the one that is complete by now, if there is one.
  std::optional<Frame> draw(std::size_t number, const Scene& scene, const RenderSettings& settings);
  /// Returns the last frame, if it is still on the device.
  std::optional<Frame> finish();

 private:
  Renderer& renderer_;
  std::optional<Session> session_;
  std::optional<PreparedFrame> prepared_;
  struct Drawing {
    std::size_t number;
    Ticket ticket;
  };
  std::optional<Drawing> drawing_;
};

}  // namespace dermis::cli::sequence
