// SPDX-License-Identifier: MIT
// The maps of the built-in head, baked from the sculpture and the painter.
#pragma once

#include "head/builtin_head/skin.h"
#include "head/builtin_head/wrap.h"
#include "head/scene/asset_data.h"
#include "image/image.h"

namespace dermis::builtin_head {

/// Margin of the chart in the unit square, so that filtering and blurring never reach the border of the map.
inline constexpr float chart_margin = 1.0f / 64.0f;

/// Returns the texture coordinates of a place in the chart, u to the right, v down. Columns of the net grow
/// to the left side of the head, rows upwards.
inline vec2 chart_uv(const vec2& chart) {
  const float inner = 1.0f - 2.0f * chart_margin;
  return {chart_margin + inner * chart.x, 1.0f - chart_margin - inner * chart.y};
}

struct Maps {
  image::Image8 colour;      ///< sRGB, alpha 255
  image::Image8 normal;      ///< tangent space of the mesh, +Y up
  image::Image8 reflection;  ///< R: specular intensity, G: roughness
};

/// Returns sRGB, 0..255, of a linear value, by a table.
std::uint8_t linear_to_srgb8(float linear);

/// Bakes the maps. `mesh` holds the net's nodes row by row (Net::index), with normals and tangents. Texels
/// beyond the chart repeat its border.
Maps bake(const Sculpture& bust, const Net& net, const scene::Primitive& mesh, int map_size,
          const Complexion& complexion);

}  // namespace dermis::builtin_head
