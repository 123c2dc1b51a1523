// SPDX-License-Identifier: MIT
#include "cli/profile_swatches.h"

#include <array>
#include <cmath>
#include <vector>

#include "base/core/parallel.h"
#include "image/colour.h"
#include "tissue/optics/skin_colour.h"

namespace dermis::cli {

image::Image8 skin_swatches(const SpectralSkin& fixed) {
  constexpr int columns = 12, rows = 8, side = 48;
  std::vector<std::array<std::uint8_t, 3>> colours(columns * rows);
  parallel_for(colours.size(), [&](std::size_t i) {
    SpectralSkin skin = fixed;
    skin.melanin = 0.001 * std::pow(500.0, static_cast<double>(i % columns) / (columns - 1));
    skin.haemoglobin = 0.001 * std::pow(100.0, static_cast<double>(i / columns) / (rows - 1));
    const optics::Rgb linear = optics::skin_colour(skin);
    for (int c = 0; c < 3; ++c) colours[i][c] = image::linear_to_srgb8(static_cast<float>(linear[c]));
  });
  image::Image8 picture{.width = columns * side,
                        .height = rows * side,
                        .rgba = std::vector<std::uint8_t>(columns * side * rows * side * 4, 255)};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = colours[y / side * columns + x / side][c];
  return picture;
}

}  // namespace dermis::cli
