// SPDX-License-Identifier: MIT
/// A rectangle of pixels, beside which there is nothing to compute.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "gpu/vulkan.h"
#include "render/passes/pixels/pixel_area_io.h"

namespace dermis::passes {

/// Pixels from `low` to before `high`; none if these are equal.
struct PixelArea {
  glm::uvec2 low{0}, high{0};
  glm::uvec2 size() const { return high - low; }
  VkRect2D rectangle() const {
    return {{static_cast<std::int32_t>(low.x), static_cast<std::int32_t>(low.y)}, {size().x, size().y}};
  }
  io::PixelAreaIo io() const { return {.low = low, .size = size()}; }
};

/// Returns the same in a picture that begins elsewhere in its targets; none stays none.
inline PixelArea moved(const PixelArea& area, const glm::uvec2& by) {
  return area.low == area.high ? PixelArea{} : PixelArea{area.low + by, area.high + by};
}

/// Returns what of it lies in these rows; none if there is nothing.
inline PixelArea rows_of(const PixelArea& area, std::uint32_t first, std::uint32_t end) {
  const std::uint32_t low = glm::max(area.low.y, first), high = glm::min(area.high.y, end);
  return low < high ? PixelArea{{area.low.x, low}, {area.high.x, high}} : PixelArea{};
}

/// Returns the same in a picture of half the width and height.
inline PixelArea halved(const PixelArea& area) { return {area.low / 2u, (area.high + 1u) / 2u}; }

/// Returns the same with the pixels around it that are in a texture of this size; none stays none.
inline PixelArea with_rim(const PixelArea& area, const glm::uvec2& size) {
  if (area.low == area.high) return area;
  return {area.low - glm::min(area.low, glm::uvec2(1)), glm::min(area.high + 1u, size)};
}

}  // namespace dermis::passes
