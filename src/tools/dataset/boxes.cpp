// SPDX-License-Identifier: MIT
#include "tools/dataset/boxes.h"

#include <algorithm>
#include <utility>

namespace dermis::dataset {
namespace {

/// A box that grows.
struct Growing {
  int left = 1 << 30, top = 1 << 30, right = -1, bottom = -1;
  std::uint64_t area = 0;

  void add(int x, int y) {
    left = std::min(left, x), right = std::max(right, x);
    top = std::min(top, y), bottom = std::max(bottom, y);
    ++area;
  }
  Box box() const {
    if (area == 0) return {};
    return {left, top, right - left + 1, bottom - top + 1, area};
  }
};

bool is_in(const image::Image8& mask, std::size_t pixel, int value) {
  const int found = mask.rgba16[4 * pixel];
  return value == 0 ? found != 0 : found == value;
}

}  // namespace

Box box_of(const image::Image8& mask, int value) {
  Growing box;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      if (is_in(mask,
                static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) +
                    static_cast<std::size_t>(x),
                value))
        box.add(x, y);
  return box.box();
}

std::vector<Box> boxes_of_parts(const image::Image8& mask, int value, std::uint64_t least_pixels) {
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) + static_cast<std::size_t>(x);
  };
  std::vector<bool> seen(at(0, mask.height));
  std::vector<Box> boxes;
  std::vector<std::pair<int, int>> waiting;
  for (int y0 = 0; y0 < mask.height; ++y0)
    for (int x0 = 0; x0 < mask.width; ++x0) {
      Growing part;
      const auto visit = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= mask.width || y >= mask.height) return;
        if (seen[at(x, y)] || !is_in(mask, at(x, y), value)) return;
        seen[at(x, y)] = true;
        part.add(x, y);
        waiting.emplace_back(x, y);
      };
      visit(x0, y0);
      while (!waiting.empty()) {
        const auto [x, y] = waiting.back();
        waiting.pop_back();
        visit(x - 1, y), visit(x + 1, y), visit(x, y - 1), visit(x, y + 1);
      }
      if (part.area >= std::max<std::uint64_t>(least_pixels, 1)) boxes.push_back(part.box());
    }
  return boxes;
}

}  // namespace dermis::dataset
