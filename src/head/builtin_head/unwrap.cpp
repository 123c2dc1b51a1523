// SPDX-License-Identifier: MIT
#include "head/builtin_head/unwrap.h"

#include <array>

#include "base/core/parallel.h"

namespace dermis::builtin_head {
namespace {

// Returns the texels per mm of a place, over those of the back of the head.
float chart_density(const vec3& p, const Frame& ear) {
  const auto near = [](const vec3& q, const vec3& centre, const vec3& radii) {
    const vec3 d = (q - centre) / radii;
    return std::exp(-glm::dot(d, d));
  };
  const vec3 m(std::abs(p.x), p.y, p.z);
  return 1.0f + 0.7f * near(m, {0, -30, 95}, {62, 75, 55}) + 0.5f * near(m, ear.origin, {20, 36, 30});
}

// A triangle as it is on the skin: cotangents of its angles and its area, in the metric of the density.
struct RestTriangle {
  std::array<float, 3> cotangent{};
  float area = 0;
};

RestTriangle rest_of(const std::array<vec3, 3>& at, float scale) {
  RestTriangle rest;
  const vec3 normal = glm::cross(at[1] - at[0], at[2] - at[0]);
  const float edges2 = glm::dot(at[1] - at[0], at[1] - at[0]) + glm::dot(at[2] - at[0], at[2] - at[0]);
  const float twice = std::max(glm::length(normal), 1e-3f * edges2 + 1e-6f);  // slivers weigh little
  for (std::size_t k = 0; k < 3; ++k) {
    const vec3 a = at[(k + 1) % 3] - at[k], b = at[(k + 2) % 3] - at[k];
    rest.cotangent[k] = glm::dot(a, b) / twice;
  }
  rest.area = 0.5f * twice * scale * scale;
  return rest;
}

// Cost of a triangle as a function of the place of one of its corners.
struct FanCorner {
  vec2 next{0}, last{0};  // the others, counter-clockwise
  float own_cotangent = 0, next_cotangent = 0, last_cotangent = 0, area = 0;
};

struct StretchCost {
  float value = 0;
  vec2 slope{0};
};

constexpr float turned_over = 1e30f;

// The chart of a net, or of every second or fourth of its nodes.
class Chart {
 public:
  Chart(const Net& net, const Frame& ear, int step)
      : columns(net.columns / step),
        rows(net.rows / step),
        uv(static_cast<std::size_t>((columns + 1) * (rows + 1))) {
    std::vector<vec3> at(uv.size());
    for (int j = 0; j <= rows; ++j) {
      for (int i = 0; i <= columns; ++i) at[index(i, j)] = net.at_mm[net.index(i * step, j * step)];
    }
    float whole = 0;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        for (const bool upper : {false, true}) {
          const std::array<std::size_t, 3> c = corners(i, j, upper);
          const std::array<vec3, 3> p = {at[c[0]], at[c[1]], at[c[2]]};
          rest_.push_back(rest_of(p, chart_density((p[0] + p[1] + p[2]) / 3.0f, ear)));
          whole += rest_.back().area;
        }
      }
    }
    for (RestTriangle& rest : rest_) rest.area /= whole;
  }

  void lay_evenly() {
    for (int j = 0; j <= rows; ++j) {
      for (int i = 0; i <= columns; ++i) uv[index(i, j)] = vec2(i, j) / vec2(columns, rows);
    }
  }

  // Takes over a chart of every second node: halves edges and diagonals, which turns no triangle over.
  void lay_as(const Chart& coarse) {
    for (int j = 0; j <= rows; ++j) {
      for (int i = 0; i <= columns; ++i)
        uv[index(i, j)] = 0.5f * (coarse.uv[coarse.index(i / 2, j / 2)] +
                                  coarse.uv[coarse.index((i + 1) / 2, (j + 1) / 2)]);
    }
  }

  // Moves each node to where its triangles are least stretched, a quarter of the nodes at a time, of which
  // none are neighbours.
  void relax(int rounds) {
    for (int round = 0; round < 4 * rounds; ++round) {
      const int first_i = round % 2, first_j = round / 2 % 2;
      parallel_for(static_cast<std::size_t>((rows - first_j) / 2 + 1), [&](std::size_t row) {
        const int j = first_j + 2 * static_cast<int>(row);
        for (int i = first_i; i <= columns; i += 2) move(i, j);
      });
    }
  }

  const int columns, rows;
  std::vector<vec2> uv;

 private:
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * (columns + 1) + i); }
  std::array<std::size_t, 3> corners(int i, int j, bool upper) const {
    if (upper) return {index(i, j), index(i + 1, j + 1), index(i, j + 1)};
    return {index(i, j), index(i + 1, j), index(i + 1, j + 1)};
  }

  // The triangles around a node.
  struct Fan {
    std::array<FanCorner, 6> corner;
    int count = 0;
    StretchCost at(const vec2& p) const;
  };
  Fan fan(int i, int j) const;
  void move(int i, int j);

  std::vector<RestTriangle> rest_;
};

StretchCost Chart::Fan::at(const vec2& p) const {
  StretchCost sum;
  for (int k = 0; k < count; ++k) {
    const FanCorner& c = corner[static_cast<std::size_t>(k)];
    const vec2 a = c.next - p, b = c.last - p, across = c.last - c.next;
    const float area = 0.5f * (a.x * b.y - a.y * b.x);
    if (!(area > 1e-9f * c.area)) return {turned_over, vec2(0)};
    const float spread = 0.5f * (c.own_cotangent * glm::dot(across, across) +
                                 c.next_cotangent * glm::dot(b, b) + c.last_cotangent * glm::dot(a, a));
    const float shrunk = c.area / area;
    const vec2 spread_slope = -c.next_cotangent * b - c.last_cotangent * a,
               area_slope = 0.5f * vec2(-across.y, across.x);
    sum.value += spread * (1 + shrunk * shrunk);
    sum.slope += (1 + shrunk * shrunk) * spread_slope - 2 * spread * shrunk * shrunk / area * area_slope;
  }
  return sum;
}

Chart::Fan Chart::fan(int i, int j) const {
  Fan fan;
  const auto add = [&](int ci, int cj, bool upper, std::size_t own) {
    if (ci < 0 || cj < 0 || ci >= columns || cj >= rows) return;
    const std::array<std::size_t, 3> c = corners(ci, cj, upper);
    const RestTriangle& rest = rest_[static_cast<std::size_t>(2 * (cj * columns + ci) + (upper ? 1 : 0))];
    const std::size_t next = (own + 1) % 3, last = (own + 2) % 3;
    fan.corner[static_cast<std::size_t>(fan.count++)] = {
        uv[c[next]], uv[c[last]], rest.cotangent[own], rest.cotangent[next], rest.cotangent[last], rest.area};
  };
  add(i, j, false, 0), add(i, j, true, 0);
  add(i - 1, j, false, 1), add(i - 1, j - 1, true, 1);
  add(i - 1, j - 1, false, 2), add(i, j - 1, true, 2);
  return fan;
}

void Chart::move(int i, int j) {
  // Nodes of a side slide along it.
  const vec2 free(i > 0 && i < columns ? 1 : 0, j > 0 && j < rows ? 1 : 0);
  if (free == vec2(0)) return;
  const Fan around = fan(i, j);
  vec2& p = uv[index(i, j)];
  const StretchCost here = around.at(p);
  const vec2 slope = here.slope * free;

  // One step of Newton's method, its second derivatives from differences of slopes.
  float reach = 0;
  for (int k = 0; k < around.count; ++k)
    reach +=
        glm::distance(around.corner[static_cast<std::size_t>(k)].next, p) / static_cast<float>(around.count);
  const float h = 1e-3f * reach;
  const StretchCost x = around.at(p + vec2(h, 0)), y = around.at(p + vec2(0, h));
  vec2 step = -slope;
  if (x.value < turned_over && y.value < turned_over) {
    const float xx = (x.slope.x - here.slope.x) / h, yy = (y.slope.y - here.slope.y) / h,
                xy = free.x * free.y * 0.5f * (x.slope.y + y.slope.x - here.slope.x - here.slope.y) / h;
    const float det = xx * yy - xy * xy;
    if (xx > 0 && yy > 0 && det > 1e-4f * xx * yy)
      step = -vec2(yy * slope.x - xy * slope.y, xx * slope.y - xy * slope.x) / det;
  }
  step *= free;
  const float length = glm::length(step);
  if (!(length > 0)) return;
  if (length > reach) step *= reach / length;

  for (int halving = 0; halving < 8; ++halving, step *= 0.5f) {
    if (around.at(p + step).value < here.value) {
      p += step;
      return;
    }
  }
}

}  // namespace

std::vector<vec2> unwrap(const Net& net, const Frame& ear) {
  Chart coarse(net, ear, 4), middle(net, ear, 2), fine(net, ear, 1);
  coarse.lay_evenly();
  coarse.relax(200);
  middle.lay_as(coarse);
  middle.relax(60);
  fine.lay_as(middle);
  fine.relax(15);
  return std::move(fine.uv);
}

}  // namespace dermis::builtin_head
