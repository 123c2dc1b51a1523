// SPDX-License-Identifier: MIT
/// Adds the light that a group of terms brings through the body to the light spread so far; see
/// passes/transmission.h.
#pragma once

#include "passes/compute_pass.h"
#include "passes/light_pool.h"

namespace dermis::passes {

class AddTransmitted : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  } settings;
  struct In {
    frame::TextureId light;  ///< RGBA16F pool: spread so far
    /// RGBA16F pool: what comes through; changed in place, the sum where there is light, and its alpha
    frame::TextureId through;
  } in;
  struct Out {
    frame::TextureId light;  ///< the sum
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
