// SPDX-License-Identifier: MIT
/// The place where the skin of a head is lit and blurred: a square in a pool of textures that all heads of a
///   batch share.
/// Based on: [JG08] sec. 4: memory is allocated once for the largest map; a smaller one uses a corner of it
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "frame/graph.h"
#include "passes/frame_data.h"

namespace dermis::passes {

/// Returns the side of a map that is halved `halvings` times if the head uses all T_max texels. A head that
/// uses fewer texels halves less often: its light has at least half as many texels per side as a near head's,
/// and never more than T_max >> halvings.
inline std::uint32_t halved_side(std::uint32_t side, std::uint32_t largest_side, std::uint32_t halvings) {
  for (std::uint32_t scaled = 2 * side; halvings > 0 && scaled <= largest_side; scaled *= 2) --halvings;
  return side >> halvings;
}

/// Returns a side that halved_side() never exceeds, for heads that use `most` texels of a side or fewer.
inline std::uint32_t most_halved_side(std::uint32_t most, std::uint32_t largest_side,
                                      std::uint32_t halvings) {
  return std::min(most, (largest_side + 1) >> halvings);
}

/// Light of one skin mesh of one head, in maps of one size. Each frame sets its position in them and the used
/// part of its square: Instance::map_places, Instance::map_side.
struct MapSquare {
  std::uint32_t instance = 0;
  std::uint32_t mesh = 0;      ///< among the skin meshes of the plan
  std::uint32_t halvings = 0;  ///< of the maps: progressive maps store wide light with fewer texels
};

inline const Instance& instance_of(const FrameData& frame, const MapSquare& square) {
  return frame.instances[square.instance];
}
/// Returns the number of the mesh among those of its asset.
inline std::uint32_t mesh_in_asset(const FrameData& frame, const MapSquare& square) {
  return square.mesh - instance_of(frame, square).first_mesh;
}

/// Returns which terms are read from the maps of a square in this frame.
MappedTerms terms_of(const FrameData& frame, const MapSquare& square);

/// Returns what halved_side() takes for T_max where a head that uses fewer texels than T_max, however few
/// fewer, halves less often: then it has at least the texels per sigma that a near head has. Halved maps need
/// room for that: see most_halved_side().
inline std::uint32_t careful_largest_side(std::uint32_t largest_side) { return 2 * largest_side - 1; }

/// A square as a frame uses it.
struct UsedSquare : MapSquare {
  std::uint32_t index = 0;  ///< of the square in its pool
  glm::uvec2 origin{0};     ///< texels
  std::uint32_t side = 0;   ///< of the used part, texels
  VkRect2D area() const;
};
UsedSquare used_square(const FrameData& frame, const MapSquare& square);
/// Returns how many texels of maps that are not halved lie along a side of a texel of maps of these halvings.
double full_texels(const FrameData& frame, MapSquare square, std::uint32_t halvings);
/// Returns the squares that hold light in this frame: of visible heads that read at least one term from them.
std::vector<UsedSquare> used_squares(const FrameData& frame, const std::vector<MapSquare>& squares);
/// Returns those whose chain of blurs has begun with this step of blur_steps(), or before.
std::vector<UsedSquare> blurred_squares(const FrameData& frame, const std::vector<MapSquare>& squares,
                                        std::uint32_t step);

}  // namespace dermis::passes
