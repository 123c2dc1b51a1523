// SPDX-License-Identifier: MIT
#include "head/scene/surface/coverage.h"

#include "base/core/assert.h"
#include "base/core/warnings.h"
#include "head/scene/surface/topology.h"

namespace dermis::scene {
namespace {

constexpr std::int64_t sub = 256;  // steps per texel

std::int64_t floor_div(std::int64_t a, std::int64_t b) {  // b > 0
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

}  // namespace

TexelTriangle::TexelTriangle(const std::array<glm::vec2, 3>& uv, int side) : side_(side) {
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 p =
        glm::clamp(glm::dvec2(uv[k]), glm::dvec2(-1), glm::dvec2(2)) * (static_cast<double>(side) * sub);
    x_[k] = std::llround(p.x);
    y_[k] = std::llround(p.y);
  }
  const std::int64_t area2 = (x_[1] - x_[0]) * (y_[2] - y_[0]) - (x_[2] - x_[0]) * (y_[1] - y_[0]);
  if (area2 == 0) return;
  if (area2 < 0) std::swap(x_[1], x_[2]), std::swap(y_[1], y_[2]);
  const auto [low, high] = std::minmax_element(y_.begin(), y_.end());
  first_row_ = static_cast<int>(std::clamp<std::int64_t>(floor_div(*low, sub), 0, side));
  end_row_ = static_cast<int>(std::clamp<std::int64_t>(floor_div(*high, sub) + 1, 0, side));
}

TexelSpan TexelTriangle::row(int y) const {
  const std::int64_t centre_y = y * sub + sub / 2;
  std::int64_t begin = 0, end = side_;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t n = (k + 1) % 3;
    const std::int64_t dx = x_[n] - x_[k], dy = y_[n] - y_[k];

    // Edge function at the centre of column c: at_zero + c * step, positive inside. y runs down and triangles
    // wind clockwise, so a left edge goes up and a top edge to the right; centres on an edge count only for
    // those.
    const std::int64_t at_zero = dx * (centre_y - y_[k]) - dy * (sub / 2 - x_[k]), step = -dy * sub;
    const std::int64_t least = dy < 0 || (dy == 0 && dx > 0) ? 0 : 1;

    if (step > 0) {
      begin = std::max(begin, -floor_div(at_zero - least, step));
    } else if (step < 0) {
      end = std::min(end, floor_div(at_zero - least, -step) + 1);
    } else if (at_zero < least) {
      end = begin;
    }
  }

  // In a row above a horizontal edge the slanted edges are followed beyond their ends, so the span may be
  // empty and lie past the map.
  begin = std::min<std::int64_t>(begin, side_);
  end = std::clamp<std::int64_t>(end, begin, side_);
  return {y, static_cast<int>(begin), static_cast<int>(end)};
}

std::array<glm::vec2, 3> triangle_uv(const SkinMesh& mesh, std::size_t t) {
  const auto uv = [&](std::size_t k) { return mesh.unwrap[mesh.indices[3 * t + k]]; };
  return {uv(0), uv(1), uv(2)};
}

double uv_area_sum(const SkinMesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
    const std::array<glm::vec2, 3> uv = triangle_uv(mesh, t);
    sum += 0.5 * std::abs(uv_area2(uv[0], uv[1], uv[2]));
  }
  return sum;
}

double uv_overlap_fraction(const SkinMesh& mesh, int resolution) {
  DERMIS_ASSERT_LT(0, resolution);
  DERMIS_ASSERT_LE(resolution, 16384);
  if (uv_area_sum(mesh) > 64) return 1;
  std::vector<std::uint8_t> count(static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution),
                                  0);
  for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
    for_each_texel(triangle_uv(mesh, t), resolution, [&](int x, int y) {
      std::uint8_t& c = count[static_cast<std::size_t>(y) * static_cast<std::size_t>(resolution) +
                              static_cast<std::size_t>(x)];
      if (c < 2) ++c;
    });
  }
  const auto covered = std::count_if(count.begin(), count.end(), [](std::uint8_t c) { return c > 0; });
  const auto twice = std::count(count.begin(), count.end(), std::uint8_t{2});
  return covered > 0 ? static_cast<double>(twice) / static_cast<double>(covered) : 0;
}

void warn_overlap(const SkinMesh& mesh) {
  if (mesh.overlap <= 0.005) return;
  const char* advice =
      "so these places share one light map: light of one will show on the other. Unwrap the skin without "
      "overlaps (mirrored halves side by side) and bake its maps again";
  warn_of(fmt::format("skin: texture coordinates overlap, {}", advice), mesh.name,
          fmt::format("skin '{}': {:.1f} % of its texture coordinates overlap, {}", mesh.name,
                      100 * mesh.overlap, advice));
}

}  // namespace dermis::scene
