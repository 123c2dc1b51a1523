// SPDX-License-Identifier: MIT
#include "render/passes/asset/alpha_max.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dermis::passes {
namespace {

// A single pixel shows on every level wherever it lies, on sides that do not halve without a rest too.
TEST(AlphaMax, LosesNothing) {
  for (const auto& [width, height] : {std::pair(13, 7), std::pair(1, 9), std::pair(16, 16), std::pair(1, 1)})
    for (int pixel = 0; pixel < width * height; ++pixel) {
      image::Image8 picture{.width = width, .height = height, .rgba = {}};
      picture.rgba.resize(static_cast<std::size_t>(4 * width * height));
      picture.rgba[static_cast<std::size_t>(4 * pixel + 3)] = 200;
      const AlphaLevels levels = alpha_max_levels(picture);

      std::size_t first = 0;
      int w = width, h = height;
      for (std::uint32_t level = 0; level < levels.count;
           ++level, w = std::max(w / 2, 1), h = std::max(h / 2, 1)) {
        const int x = pixel % width, y = pixel / width;
        const auto at = [&](double u, double v) {
          return levels
              .bytes[first + static_cast<std::size_t>(static_cast<int>(v * h) * w + static_cast<int>(u * w))];
        };
        EXPECT_EQ(at((x + 0.5) / width, (y + 0.5) / height), 200) << "level " << level << " pixel " << pixel;
        EXPECT_EQ(at((x + 0.01) / width, (y + 0.99) / height), 200)
            << "level " << level << " pixel " << pixel;
        first += static_cast<std::size_t>(w * h);
      }
      EXPECT_EQ(first, levels.bytes.size());
    }
}

}  // namespace
}  // namespace dermis::passes
