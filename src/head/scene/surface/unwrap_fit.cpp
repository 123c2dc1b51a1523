// SPDX-License-Identifier: MIT
#include "head/scene/surface/unwrap_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/core/warnings.h"
#include "head/scene/surface/topology.h"

namespace dermis::scene {
namespace {

constexpr double least_fill = 0.25;  // of the square's area; below it the coordinates are fitted
constexpr double most_uneven = 2;    // texels per mm along one axis over those along the other
constexpr double rim =
    1.5;  // distance from the others within which no triangle is a stray, in sides of their box
constexpr double flat = 1e-5;                // a triangle's height over its longest side
constexpr double flat_share_to_tell = 0.01;  // of the skin's area

/// The share of the skin that may be left off the map on one side of an axis, and how many times larger the
/// rest must then become.
struct Trade {
  double share, gain;
};
constexpr std::array<Trade, 3> trades{{{0.01, 4}, {0.05, 16}, {0.25, 64}}};

struct Interval {
  double low = 1e300, high = -1e300;
  double size() const { return high - low; }
  void add(double a, double b) { low = std::min(low, a), high = std::max(high, b); }
};

/// The extent of a triangle on one axis, and its area on the skin.
struct Extent {
  double low, high, area;
};

/// Returns the end below which (above which if `from_above`) at most `share` of the area begins.
double end_without(std::vector<Extent> extents, double share, bool from_above) {
  std::sort(extents.begin(), extents.end(),
            [&](const Extent& a, const Extent& b) { return from_above ? a.high > b.high : a.low < b.low; });
  double total = 0, left_out = 0;
  for (const Extent& e : extents) total += e.area;

  for (const Extent& e : extents) {
    left_out += e.area;
    if (left_out > share * total) return from_above ? e.high : e.low;
  }
  return 0;
}

/// Returns the interval of all extents, or without strays if leaving them out is worth it.
Interval without_strays(const std::vector<Extent>& extents) {
  Interval all;
  for (const Extent& e : extents) all.add(e.low, e.high);

  for (const Trade& trade : trades) {
    const Interval most{end_without(extents, trade.share, false), end_without(extents, trade.share, true)};
    if (!(most.size() > 0)) continue;

    // Triangles beside the others are no strays.
    const double around = rim * most.size();
    Interval kept;
    for (const Extent& e : extents)
      if (e.low >= most.low - around && e.high <= most.high + around) kept.add(e.low, e.high);
    if (kept.size() > 0 && trade.gain * kept.size() <= all.size()) return kept;
  }
  return all;
}

struct RawTriangle {
  std::array<glm::vec2, 3> uv;
  glm::dvec3 metric;   ///< of the raw coordinates, mm^2 per unit^2 up to a constant
  double area = 0;     ///< on the skin, up to a constant
  bool valid = false;  ///< has area in texture space
};

/// Returns whether a triangle with width on the skin has hardly any in texture space.
bool flattened(const std::array<glm::vec2, 3>& uv, const std::array<glm::dvec3, 3>& p) {
  double longest_uv2 = 0, longest2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 edge_uv = glm::dvec2(uv[(k + 1) % 3]) - glm::dvec2(uv[k]);
    const glm::dvec3 edge = p[(k + 1) % 3] - p[k];
    longest_uv2 = std::max(longest_uv2, glm::dot(edge_uv, edge_uv));
    longest2 = std::max(longest2, glm::dot(edge, edge));
  }
  return std::abs(uv_area2(uv[0], uv[1], uv[2])) < flat * longest_uv2 &&
         glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) > 100 * flat * longest2;
}

std::vector<RawTriangle> raw_triangles(const SkinMesh& mesh) {
  std::vector<RawTriangle> triangles(mesh.indices.size() / 3);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    RawTriangle& triangle = triangles[t];
    std::array<glm::dvec3, 3> p;
    bool finite = true;

    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex& v = mesh.vertices[mesh.indices[3 * t + k]];
      triangle.uv[k] = v.uv0;
      p[k] = glm::dvec3(v.position_m);
      finite = finite && std::isfinite(v.uv0.x) && std::isfinite(v.uv0.y);
    }

    triangle.area = 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    triangle.valid =
        finite && uv_area2(triangle.uv[0], triangle.uv[1], triangle.uv[2]) != 0 && !flattened(triangle.uv, p);
    if (triangle.valid)
      triangle.metric = triangle_metric(p[0], p[1], p[2], triangle.uv[0], triangle.uv[1], triangle.uv[2]);
  }
  return triangles;
}

Extent extent_of(const RawTriangle& triangle, glm::length_t axis) {
  const double a = triangle.uv[0][axis], b = triangle.uv[1][axis], c = triangle.uv[2][axis];
  return {std::min({a, b, c}), std::max({a, b, c}), triangle.area};
}

/// Returns mm of skin per unit of each axis: the geometric mean over the skin, up to one constant for both.
glm::dvec2 mean_lengths(const std::vector<RawTriangle>& triangles) {
  glm::dvec2 logarithms(0);
  double area = 0;
  for (const RawTriangle& t : triangles) {
    if (!t.valid || !(t.metric.x > 0) || !(t.metric.z > 0)) continue;
    logarithms += t.area * 0.5 * glm::dvec2(std::log(t.metric.x), std::log(t.metric.z));
    area += t.area;
  }
  return area > 0 ? glm::exp(logarithms / area) : glm::dvec2(1);
}

struct Fit {
  glm::dvec2 scale{1}, offset{0};
  bool scaled = false;
};

/// Returns the identity, a move by whole tiles, or the scale that brings [low, high] into 0..1.
Fit shrunk(const std::array<Interval, 2>& box) {
  Fit fit;
  for (glm::length_t axis = 0; axis < 2; ++axis) {
    const auto [low, high] = box[static_cast<std::size_t>(axis)];
    if (low >= 0 && high <= 1) continue;
    const double tile = std::floor(low);
    const bool by_tiles = high - tile <= 1;
    fit.scaled = fit.scaled || !by_tiles;
    fit.scale[axis] = by_tiles ? 1 : 1 / (high - low);
    fit.offset[axis] = by_tiles ? -tile : -low / (high - low);
  }
  return fit;
}

/// Returns the fit that fills the square with the box, as far as `most_uneven` allows.
Fit grown(const std::array<Interval, 2>& box, const glm::dvec2& mm_per_unit, const Fit& before) {
  const glm::dvec2 size(box[0].size(), box[1].size());
  const glm::dvec2 largest = (1 - 2 * fit_margin) / size;
  const glm::dvec2 texels_per_mm = largest / mm_per_unit;
  const double coarser = std::min(texels_per_mm.x, texels_per_mm.y);

  Fit fit = before;
  for (glm::length_t axis = 0; axis < 2; ++axis) {
    const double scale = std::min(largest[axis], most_uneven * coarser * mm_per_unit[axis]);
    if (scale <= before.scale[axis]) continue;
    const Interval& side = box[static_cast<std::size_t>(axis)];
    fit.scale[axis] = scale;
    fit.offset[axis] = 0.5 - scale * 0.5 * (side.low + side.high);
    fit.scaled = true;
  }
  return fit;
}

bool within(const RawTriangle& triangle, const std::array<Interval, 2>& box) {
  for (glm::length_t axis = 0; axis < 2; ++axis) {
    const Extent e = extent_of(triangle, axis);
    const Interval& side = box[static_cast<std::size_t>(axis)];
    if (e.low < side.low || e.high > side.high) return false;
  }
  return true;
}

void tell_of_fit(SkinMesh& mesh, const std::array<Interval, 2>& box, const Fit& fit) {
  if (fit.scaled) {
    mesh.unwrap_note =
        fmt::format("texture coordinates span u {:.4g} to {:.4g}, v {:.4g} to {:.4g}: scaled to fit 0..1",
                    box[0].low, box[0].high, box[1].low, box[1].high);
    // A rounding error outside costs nothing; a second tile costs resolution, and tiles meant to coincide now
    // lie side by side.
    if (std::min(fit.scale.x, fit.scale.y) < 0.999)
      warn_of(
          "skin: texture coordinates lie outside 0..1 and are scaled to fit; maps hold fewer texels per mm",
          mesh.name,
          fmt::format("skin '{}': {}; the map holds fewer texels per mm", mesh.name, mesh.unwrap_note));
  } else if (fit.offset != glm::dvec2(0)) {
    mesh.unwrap_note =
        fmt::format("texture coordinates moved by {:+g}, {:+g} tiles", fit.offset.x, fit.offset.y);
  }
}

/// Warns about triangles that the map does not hold.
void tell_of_lost(const SkinMesh& mesh, const std::vector<RawTriangle>& triangles, std::size_t strays) {
  if (strays > 0)
    warn_of(
        "skin: texture coordinates of some triangles lie far from all others; these are lit without "
        "scattering",
        mesh.name,
        fmt::format("skin '{}': the texture coordinates of {} of its {} triangles lie far from all others; "
                    "these are lit without scattering",
                    mesh.name, strays, triangles.size()));

  double area = 0, lost = 0;
  bool any = false;  // missing coordinates are all zero; the loader has warned of them
  for (const RawTriangle& t : triangles) {
    area += t.area;
    if (!t.valid) lost += t.area;
    for (const glm::vec2& uv : t.uv) any = any || uv != glm::vec2(0);
  }
  if (any && lost > flat_share_to_tell * area)
    warn_of("skin: texture coordinates without area; there it is lit without scattering", mesh.name,
            fmt::format("skin '{}': {:.3g} % of it has texture coordinates without area; it is lit without "
                        "scattering",
                        mesh.name, 100 * lost / area));
}

}  // namespace

std::vector<bool> fit_unwrap(SkinMesh& mesh) {
  const std::vector<RawTriangle> triangles = raw_triangles(mesh);
  std::array<Interval, 2> box{Interval{0, 0}, Interval{0, 0}};
  for (glm::length_t axis = 0; axis < 2; ++axis) {
    std::vector<Extent> extents;
    for (const RawTriangle& t : triangles)
      if (t.valid) extents.push_back(extent_of(t, axis));
    if (!extents.empty()) box[static_cast<std::size_t>(axis)] = without_strays(extents);
  }

  std::vector<bool> on_map;
  std::size_t strays = 0;
  for (const RawTriangle& t : triangles) {
    on_map.push_back(t.valid && within(t, box));
    strays += t.valid && !on_map.back() ? 1 : 0;
  }

  Fit fit = shrunk(box);
  const double filled = box[0].size() * fit.scale.x * box[1].size() * fit.scale.y;
  if (filled > 0 && filled < least_fill) fit = grown(box, mean_lengths(triangles), fit);
  mesh.unwrap_scale = fit.scale;
  mesh.unwrap_offset = fit.offset;
  tell_of_fit(mesh, box, fit);
  tell_of_lost(mesh, triangles, strays);

  mesh.unwrap.reserve(mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) {
    const glm::dvec2 uv = glm::dvec2(vertex.uv0) * mesh.unwrap_scale + mesh.unwrap_offset;
    const bool valid = std::isfinite(uv.x) && std::isfinite(uv.y);
    mesh.unwrap.emplace_back(valid ? glm::clamp(uv, glm::dvec2(0), glm::dvec2(1)) : glm::dvec2(0));
  }
  return on_map;
}

}  // namespace dermis::scene
