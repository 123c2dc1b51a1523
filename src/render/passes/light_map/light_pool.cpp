// SPDX-License-Identifier: MIT
#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

VkRect2D UsedSquare::area() const {
  return {{static_cast<std::int32_t>(origin.x), static_cast<std::int32_t>(origin.y)}, {side, side}};
}

MappedTerms terms_of(const FrameData& frame, const MapSquare& square) {
  const std::vector<MappedTerms>& terms = head_of(frame, square).mapped_terms;
  return terms.empty() ? MappedTerms{} : terms[mesh_in_asset(frame, square)];
}

bool holds_light(const FrameData& frame, const MapSquare& square) {
  return head_of(frame, square).visible && terms_of(frame, square).any;
}

UsedSquare used_square(const FrameData& frame, const MapSquare& square) {
  const Head& head = head_of(frame, square);
  const bool has_place = !head.map_places.empty();
  return {square, has_place ? head.map_places[mesh_in_asset(frame, square)] : MapPlace{}, head.detail.side};
}

std::vector<UsedSquare> used_squares(const FrameData& frame, const std::vector<MapSquare>& squares) {
  std::vector<UsedSquare> used;
  for (const MapSquare& square : squares)
    if (holds_light(frame, square)) used.push_back(used_square(frame, square));
  return used;
}

std::vector<UsedSquare> blurred_squares(const FrameData& frame, const std::vector<MapSquare>& squares,
                                        std::uint32_t step) {
  std::vector<UsedSquare> used = used_squares(frame, squares);
  std::erase_if(used, [&](const UsedSquare& s) { return terms_of(frame, s).first_step > step; });
  return used;
}

}  // namespace dermis::passes
