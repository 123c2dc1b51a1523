// SPDX-License-Identifier: MIT
#include "truth/reference/maps.h"

#include <algorithm>
#include <cmath>

#include "head/scene/wrap.h"
#include "image/colour.h"

namespace dermis::reference {
namespace {

using scene::split;
using scene::wrapped;

const std::array<double, 256>& linear_of_srgb() {
  static const std::array<double, 256> table = [] {
    std::array<double, 256> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = image::srgb8_to_linear(static_cast<std::uint8_t>(i));
    return t;
  }();
  return table;
}

}  // namespace

glm::dvec4 MapPixels::texel(int x, int y) const {
  const std::uint8_t* p = pixels_.at(x, y);
  if (!srgb_) return glm::dvec4(p[0], p[1], p[2], p[3]) / 255.0;
  const auto& linear = linear_of_srgb();
  return {linear[p[0]], linear[p[1]], linear[p[2]], p[3] / 255.0};
}

glm::dvec4 MapPixels::bilinear(glm::dvec2 uv, const scene::MapRef& map) const {
  const int w = pixels_.width, h = pixels_.height;
  double fx = 0, fy = 0;
  if (map.nearest) {
    const int x = split(uv.x * w, fx), y = split(uv.y * h, fy);
    return texel(wrapped(x, w, map.wrap_u), wrapped(y, h, map.wrap_v));
  }
  const int x = split(uv.x * w - 0.5, fx), y = split(uv.y * h - 0.5, fy);
  const int x0 = wrapped(x, w, map.wrap_u), x1 = wrapped(x + 1, w, map.wrap_u);
  const int y0 = wrapped(y, h, map.wrap_v), y1 = wrapped(y + 1, h, map.wrap_v);
  return glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), fx), glm::mix(texel(x0, y1), texel(x1, y1), fx), fy);
}

glm::dvec4 MapSlot::read(const std::array<glm::dvec2, 2>& uv) const {
  const glm::dvec2 at = glm::dmat3x2(map.transform) * glm::dvec3(uv[static_cast<std::size_t>(map.uv_set)], 1);
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return glm::dvec4(0);
  return pixels->bilinear(at, map);
}

}  // namespace dermis::reference
