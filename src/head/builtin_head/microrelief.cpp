// SPDX-License-Identifier: MIT
#include "head/builtin_head/microrelief.h"

#include <vector>

#include "base/core/parallel.h"
#include "head/builtin_head/clay.h"
#include "head/builtin_head/noise.h"

namespace dermis::builtin_head {
namespace {

constexpr float tile_mm = 20.0f;
// Cells along the tile, of the lines and of the finer ones that cross their plateaus.
constexpr int coarse = 36, fine = 80;

// Returns the difference of the distances to the two nearest points, in cells, and a random number of the
// nearest. One point per cell of a plane whose cells repeat.
struct Plateau {
  float from_line = 0, level = 0;
};
Plateau plateau(const vec2& at, int cells, std::uint32_t seed) {
  const int i = static_cast<int>(at.x), j = static_cast<int>(at.y);
  float first2 = 1e9f, second2 = 1e9f;
  Plateau found;
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      const std::uint32_t h = lattice_hash((i + di + cells) % cells, (j + dj + cells) % cells, 0, seed);
      const vec2 point(static_cast<float>(i + di) + 0.1f + 0.8f * unit(h << 16),
                       static_cast<float>(j + dj) + 0.1f + 0.8f * unit(h));
      const vec2 d = point - at;
      const float d2 = glm::dot(d, d);
      if (d2 < first2) found.level = unit(h * 2246822519u);
      second2 = std::min(second2, std::max(first2, d2));
      first2 = std::min(first2, d2);
    }
  }
  found.from_line = std::sqrt(second2) - std::sqrt(first2);
  return found;
}

float height_mm(const vec2& part) {
  const Plateau main = plateau(part * static_cast<float>(coarse), coarse, 301),
                between = plateau(part * static_cast<float>(fine), fine, 307);
  return -0.016f * (1 - smooth_step(0.0f, 0.34f, main.from_line)) -
         0.005f * (1 - smooth_step(0.0f, 0.40f, between.from_line)) + 0.004f * main.level;
}

}  // namespace

image::Image8 microrelief(int side) {
  const auto texels = static_cast<std::size_t>(side);
  std::vector<float> heights(texels * texels);
  parallel_for(texels, [&](std::size_t y) {
    for (std::size_t x = 0; x < texels; ++x)
      heights[y * texels + x] = height_mm((vec2(x, y) + 0.5f) / static_cast<float>(side));
  });

  image::Image8 map;
  map.width = map.height = side;
  map.rgba.assign(4 * texels * texels, 255);
  const float texel_mm = tile_mm / static_cast<float>(side);
  for (std::size_t y = 0; y < texels; ++y) {
    for (std::size_t x = 0; x < texels; ++x) {
      const std::size_t right = (x + 1) % texels, left = (x + texels - 1) % texels, below = (y + 1) % texels,
                        above = (y + texels - 1) % texels;
      // Rows run down, +Y up.
      const vec3 n =
          glm::normalize(vec3(heights[y * texels + left] - heights[y * texels + right],
                              heights[below * texels + x] - heights[above * texels + x], 2 * texel_mm));
      for (int c = 0; c < 3; ++c)
        map.rgba[4 * (y * texels + x) + static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(n[c] * 127.0f + 128.0f);
    }
  }
  return map;
}

}  // namespace dermis::builtin_head
