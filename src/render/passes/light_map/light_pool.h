// SPDX-License-Identifier: MIT
/// The place where the skin of a head is lit and blurred: a square in a pool of textures that all heads of a
/// batch share.
/// Based on: [JG08] sec. 4: memory is allocated once for the largest map; a smaller one uses a corner of it
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "frame/graph.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

/// Light of one skin mesh of one head. Each frame sets its position in the maps and the used part of its
/// square: Head::map_places, Head::detail.
struct MapSquare {
  std::uint32_t head = 0;  ///< of the frame
  std::uint32_t mesh = 0;  ///< among the skin meshes of the plan
};

/// A skin mesh of a head, and the number of the first of its parts among those of the frame: GpuDraw::parts.
struct SkinParts {
  MapSquare square;
  std::uint32_t first_part = 0;
};

inline const Head& head_of(const FrameData& frame, const MapSquare& square) {
  return frame.heads[square.head];
}
/// Returns the number of the mesh among those of its asset.
inline std::uint32_t mesh_in_asset(const FrameData& frame, const MapSquare& square) {
  return square.mesh - head_of(frame, square).first_mesh;
}

/// Returns which terms are read from the maps of a square in this frame.
MappedTerms terms_of(const FrameData& frame, const MapSquare& square);

/// Returns whether a square holds light in this frame: of a visible head that reads at least one term from
/// it.
bool holds_light(const FrameData& frame, const MapSquare& square);

/// A square as a frame uses it.
struct UsedSquare : MapSquare, MapPlace {
  std::uint32_t side = 0;  ///< T, texels, in the corner of the square
  VkRect2D area() const;
};
UsedSquare used_square(const FrameData& frame, const MapSquare& square);
/// Returns those that hold light.
std::vector<UsedSquare> used_squares(const FrameData& frame, const std::vector<MapSquare>& squares);
/// Returns those whose chain of blurs has begun with this step of blur_steps(), or before.
std::vector<UsedSquare> blurred_squares(const FrameData& frame, const std::vector<MapSquare>& squares,
                                        std::uint32_t step);

}  // namespace dermis::passes
