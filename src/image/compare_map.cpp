// SPDX-License-Identifier: MIT
#include "image/compare_map.h"

#include <cmath>

#include "base/core/assert.h"

namespace dermis::image {

std::array<std::uint8_t, 3> magma(float t) {
  constexpr std::uint8_t knots[16][3] = {{0, 0, 4},       {11, 9, 36},     {32, 17, 75},    {59, 15, 112},
                                         {87, 21, 126},   {114, 31, 129},  {140, 41, 129},  {168, 50, 125},
                                         {196, 60, 117},  {222, 73, 104},  {241, 96, 93},   {250, 127, 94},
                                         {254, 159, 109}, {254, 191, 132}, {253, 222, 160}, {252, 253, 191}};
  const float at = t > 0 ? (t < 1 ? t * 15 : 15.0f) : 0.0f;  // NaN compares false
  const int knot = at < 15 ? static_cast<int>(at) : 14;
  const float part = at - static_cast<float>(knot);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    const float from = knots[knot][c], to = knots[knot + 1][c];
    colour[c] = static_cast<std::uint8_t>(std::lround(from + (to - from) * part));
  }
  return colour;
}

Image8 error_colours(const ImageF& map, float full_scale, std::span<const std::uint8_t> region) {
  DERMIS_ASSERT_EQ(map.channels, 1);
  DERMIS_ASSERT(full_scale > 0);
  DERMIS_ASSERT(region.empty() || region.size() == map.values.size());
  Image8 picture{.width = map.width,
                 .height = map.height,
                 .rgba = std::vector<std::uint8_t>(map.values.size() * 4, 255)};
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    constexpr std::array<std::uint8_t, 3> outside{96, 96, 96};
    const auto colour = region.empty() || region[i] != 0 ? magma(map.values[i] / full_scale) : outside;
    for (std::size_t c = 0; c < 3; ++c) picture.rgba[i * 4 + c] = colour[c];
  }
  return picture;
}

}  // namespace dermis::image
