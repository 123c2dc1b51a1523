// SPDX-License-Identifier: MIT
#include "head/scene/surface/walk.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace dermis::scene {
namespace {

double cross2(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }
glm::dvec2 right_of(const glm::dvec2& d) { return {d.y, -d.x}; }

/// Returns a triangle in its plane. One without area becomes 1e-9 of its longest side thick, so that lines
/// can cross it.
std::array<glm::dvec2, 3> laid_flat(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 e1 = b - a, e2 = c - a;
  const double thin =
      std::max(1e-9 * std::max({glm::length(e1), glm::length(e2), glm::length(c - b)}), 1e-100);
  const double length = std::max(glm::length(e1), thin);
  const double x = glm::dot(e1, e2) / length;
  return {glm::dvec2(0), glm::dvec2(length, 0),
          glm::dvec2(x, std::max(glm::length(glm::cross(e1, e2)) / length, thin))};
}

glm::dvec3 barycentric(const std::array<glm::dvec2, 3>& t, const glm::dvec2& p) {
  const double area2 = cross2(t[1] - t[0], t[2] - t[0]);
  glm::dvec3 b(cross2(t[1] - p, t[2] - p), cross2(t[2] - p, t[0] - p), 0);
  b /= area2;
  b.z = 1 - b.x - b.y;
  b = glm::clamp(b, glm::dvec3(0), glm::dvec3(1));
  return b / (b.x + b.y + b.z);
}

}  // namespace

Walker::Walker(const Topology& topology, std::span<const Vertex> vertices, std::span<const glm::vec2> uv,
               std::span<const std::uint32_t> indices)
    : topology_(topology), uv_(uv), indices_(indices) {
  flat_.reserve(indices.size() / 3);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const auto p = [&](std::size_t k) { return glm::dvec3(vertices[indices[i + k]].position_m); };
    flat_.push_back(laid_flat(p(0), p(1), p(2)));
  }
}

std::optional<MeshPoint> Walker::leave(std::uint32_t half, double along, const glm::dvec2& uv_vector) const {
  const std::uint32_t t = half / 3;
  const auto uv = [&](std::uint32_t k) { return glm::dvec2(uv_[indices_[3 * t + k]]); };
  const glm::dvec2 d1 = uv(1) - uv(0), d2 = uv(2) - uv(0);
  const double det = cross2(d1, d2);
  if (det == 0) return std::nullopt;
  const Flat& f = flat_[t];
  const glm::dvec2 vector =
      ((f[1] - f[0]) * cross2(uv_vector, d2) + (f[2] - f[0]) * cross2(d1, uv_vector)) / det;
  const bool corner = along <= 0 || along >= 1;
  const std::optional<State> state = corner ? turn(half, along >= 1, vector) : cross(half, along, vector);
  return state ? straight(*state) : std::nullopt;
}

/// Enters the neighbour: keeps the component along the edge, turns the outward component inwards.
std::optional<Walker::State> Walker::cross(std::uint32_t half, double along, const glm::dvec2& vector) const {
  const std::uint32_t other = topology_.mate[half];
  if (other == no_edge) return std::nullopt;
  const Flat& from = flat_[half / 3];
  const Flat& to = flat_[other / 3];
  const glm::dvec2 edge = glm::normalize(from[next_corner(half) % 3] - from[half % 3]);
  const glm::dvec2 start = to[other % 3], end = to[next_corner(other) % 3];
  const glm::dvec2 other_edge = glm::normalize(end - start);
  const bool reversed = place(half) != place(other);
  // The line never turns back: rounding, or a texel centre just inside its own triangle, could make this
  // negative.
  const double outwards = std::max(0.0, glm::dot(vector, right_of(edge)));
  const glm::dvec2 turned =
      other_edge * glm::dot(vector, edge) * (reversed ? -1.0 : 1.0) - right_of(other_edge) * outwards;
  return State{other / 3, glm::mix(start, end, reversed ? 1 - along : along), turned, 1u << other % 3};
}

/// Turns around the vertex at one end of the edge, outwards, to the triangle in which the vector lies.
std::optional<Walker::State> Walker::turn(std::uint32_t half, bool at_end, const glm::dvec2& vector) const {
  const Flat& from = flat_[half / 3];
  const glm::dvec2 a = from[half % 3], b = from[next_corner(half) % 3];
  const glm::dvec2 edge = at_end ? a - b : b - a;

  // The triangle lies to the left of a -> b: outwards is counter-clockwise around b, and clockwise around a.
  double angle = std::atan2(cross2(edge, vector), glm::dot(edge, vector)) * (at_end ? 1 : -1);
  if (angle < 0) angle += 2 * glm::pi<double>();
  const std::uint32_t vertex = place(at_end ? next_corner(half) : half);

  for (int step = 0; step < 256; ++step) {
    const std::uint32_t other = topology_.mate[half];
    if (other == no_edge) return std::nullopt;
    const Flat& flat = flat_[other / 3];
    const bool at_start = place(other) == vertex;
    const std::uint32_t base = other / 3 * 3;
    const std::uint32_t corner = at_start ? other : next_corner(other),
                        far = at_start ? next_corner(other) : other;
    const std::uint32_t third = base + 3 - corner % 3 - far % 3;
    const glm::dvec2 side = glm::normalize(flat[far % 3] - flat[corner % 3]),
                     way_on = glm::normalize(flat[third % 3] - flat[corner % 3]);
    const double inner = std::atan2(std::abs(cross2(side, way_on)), glm::dot(side, way_on));
    // the other edge at this vertex
    const std::uint32_t side_on = at_start ? base + (corner + 2) % 3 : corner;

    if (angle <= inner) {
      const glm::dvec2 inwards = right_of(side) * (cross2(side, way_on) < 0 ? 1.0 : -1.0);
      const glm::dvec2 turned = glm::length(vector) * (std::cos(angle) * side + std::sin(angle) * inwards);
      return State{other / 3, flat[corner % 3], turned, 1u << other % 3 | 1u << side_on % 3};
    }

    // The next triangle around the vertex.
    angle -= inner;
    half = side_on;
  }
  return std::nullopt;
}

std::optional<MeshPoint> Walker::straight(State state) const {
  for (int step = 0; step < 1000; ++step) {
    const Flat& flat = flat_[state.triangle];
    double nearest = 1;  // fraction of the remaining vector at which it leaves the triangle
    std::uint32_t exit = no_edge;

    for (std::uint32_t k = 0; k < 3; ++k) {
      if ((state.closed_edges >> k & 1u) != 0) continue;
      const glm::dvec2 outwards = right_of(flat[(k + 1) % 3] - flat[k]);
      const double speed = glm::dot(outwards, state.vector);
      if (speed <= 0) continue;
      const double share = std::max(0.0, -glm::dot(outwards, state.at - flat[k]) / speed);
      if (share < nearest) {
        nearest = share;
        exit = 3 * state.triangle + k;
      }
    }
    if (exit == no_edge) return MeshPoint{state.triangle, barycentric(flat, state.at + state.vector)};

    // Crosses the edge with the rest of the vector.
    const glm::dvec2 start = flat[exit % 3], edge = flat[next_corner(exit) % 3] - start;
    const double along = std::clamp(
        glm::dot(state.at + nearest * state.vector - start, edge) / glm::dot(edge, edge), 0.0, 1.0);

    const std::optional<State> next = cross(exit, along, (1 - nearest) * state.vector);
    if (!next) return std::nullopt;
    state = *next;
  }
  return std::nullopt;
}

}  // namespace dermis::scene
