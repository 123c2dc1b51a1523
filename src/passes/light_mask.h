// SPDX-License-Identifier: MIT
/// What says where the light of a map is, and how convolutions skip the texels without light.
/// Based on: [JG08] sec. 3
#pragma once

#include <cstdint>

#include "frame/graph.h"
#include "passes/tile_lists.h"

namespace dermis::passes {

/// How a convolution skips texels without light, and so how it runs.
enum class SkipUnlit : std::uint8_t {
  never,        ///< computed over the whole used square
  never_drawn,  ///< drawn over the whole used square
  by_alpha,     ///< drawn; a fragment without light ends before its taps ([JG08] sec. 3)
  by_depth,     ///< drawn; the depth test rejects it before it starts ([JG08] sec. 3)
  by_tiles      ///< computed; only tiles that hold light are dispatched
};

struct LightMask {
  SkipUnlit skip_unlit = SkipUnlit::never;
  TileLists lists = {};              ///< with SkipUnlit::by_tiles
  frame::TextureId depth_mask = {};  ///< with SkipUnlit::by_depth
};

}  // namespace dermis::passes
