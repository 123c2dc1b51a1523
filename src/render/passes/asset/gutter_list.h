// SPDX-License-Identifier: MIT
/// The gutters of a mesh for the device.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "head/scene/surface/gutters.h"
#include "render/shared/gutters_io.h"

namespace dermis::passes {

struct GutterList {
  /// scene::build_gutters, followed by each remaining empty texel within two texels of a chart: the corners
  /// where several seams meet. It takes the nearest texel's light, with chart 0, so that no bilinear read at
  /// a border finds black.
  std::vector<scene::GutterTexel> texels;
  /// For each texel, the nearest texel of the chart that it extends, whose metric it continues. The texel
  /// itself if its chart has no texel within 128, or if it extends none.
  std::vector<glm::uvec2> own;
};

/// Returns the invocations of a dispatch over so many gutters.
inline glm::uvec2 gutter_invocations(std::uint32_t count) {
  return {std::min<std::uint32_t>(count, GUTTER_ROW), (count + GUTTER_ROW - 1) / GUTTER_ROW};
}

GutterList gutter_list(const scene::SkinMesh& mesh, int side, int width_texels);

/// Returns a list as shaders read it.
std::vector<io::GutterIo> packed(const GutterList& list);

/// Returns, for each tile of a map of `side` texels, by which seen tiles its gutters bring it into a frame:
/// TileLinks of render/shared/tiles_io.h.
std::vector<std::uint32_t> tile_links(const std::vector<io::GutterIo>& gutters, std::uint32_t side);

}  // namespace dermis::passes
