// SPDX-License-Identifier: MIT
// Light that optics have spread: what render/passes/finish/bloom makes, and the tone map mixes in.
#pragma once

#include <cstdint>

#include "frame/graph.h"

namespace dermis::passes {

/// The picture, blurred by one of the two Gaussians.
struct SpreadLight {
  frame::TextureId picture;    ///< RGBA16F
  std::uint32_t halvings = 0;  ///< of its size, from that of the picture; rounded up
  float weight = 0;            ///< in the filter: both are 1
};
struct Bloom {
  SpreadLight narrow, wide;
};

}  // namespace dermis::passes
