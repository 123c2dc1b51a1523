// SPDX-License-Identifier: MIT
// Times of frames that are drawn in turns, A B C A B C, so that what changes on the machine changes all
// alike.
#pragma once

#include <atomic>
#include <vector>

#include "dermis/renderer.h"

namespace dermis::api {

/// A frame of the turns.
struct Turn {
  Scene scene;
  RenderSettings settings;
};

/// Draws all frames once to warm up, and then `rounds` times in turns. Returns the times of each, ms. Throws
/// Cancelled when `stop` is set.
std::vector<std::vector<double>> draw_in_turns(Renderer& renderer, const std::vector<Turn>& turns, int rounds,
                                               const std::atomic<bool>* stop);

}  // namespace dermis::api
