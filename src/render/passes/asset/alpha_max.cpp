// SPDX-License-Identifier: MIT
#include "render/passes/asset/alpha_max.h"

#include <algorithm>

#include "base/core/assert.h"

namespace dermis::passes {
namespace {

struct Level {
  int width, height;
  std::vector<std::uint8_t> alpha;

  std::uint8_t& at(int x, int y) {
    return alpha[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

// The pixels of a longer side that texel `i` of a shorter one covers, even partly: first to last.
struct Span {
  int first, last;
};
Span covered(int i, int shorter, int longer) {
  const auto wide = [&](int k) { return std::int64_t{k} * longer; };
  return {static_cast<int>(wide(i) / shorter), static_cast<int>((wide(i + 1) + shorter - 1) / shorter) - 1};
}

Level halved(Level& from) {
  const int width = std::max(from.width / 2, 1), height = std::max(from.height / 2, 1);
  Level to{width, height,
           std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Span columns = covered(x, width, from.width), rows = covered(y, height, from.height);
      std::uint8_t largest = 0;
      for (int v = rows.first; v <= rows.last; ++v)
        for (int u = columns.first; u <= columns.last; ++u) largest = std::max(largest, from.at(u, v));
      to.at(x, y) = largest;
    }
  return to;
}

}  // namespace

AlphaLevels alpha_max_levels(const image::Image8& picture) {
  DERMIS_ASSERT_LT(0, picture.width);
  DERMIS_ASSERT_LT(0, picture.height);
  Level level{picture.width, picture.height, std::vector<std::uint8_t>(picture.rgba.size() / 4)};
  for (std::size_t i = 0; i < level.alpha.size(); ++i) level.alpha[i] = picture.rgba[4 * i + 3];

  AlphaLevels out;
  for (;;) {
    ++out.count;
    out.bytes.insert(out.bytes.end(), level.alpha.begin(), level.alpha.end());
    if (level.width == 1 && level.height == 1) return out;
    level = halved(level);
  }
}

}  // namespace dermis::passes
