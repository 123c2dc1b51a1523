// SPDX-License-Identifier: MIT
#include "builtin_head/clay.h"

namespace dermis::builtin_head {
namespace {

template <class T>
T catmull_rom(const T& a, const T& b, const T& c, const T& d, float t) {
  return b + 0.5f * t * (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a)));
}

template <class T>
std::vector<T> through(const std::vector<T>& points, int steps) {
  std::vector<T> out;
  const int n = static_cast<int>(points.size());
  for (int i = 0; i + 1 < n; ++i) {
    const T& a = points[static_cast<std::size_t>(std::max(i - 1, 0))];
    const T& b = points[static_cast<std::size_t>(i)];
    const T& c = points[static_cast<std::size_t>(i + 1)];
    const T& d = points[static_cast<std::size_t>(std::min(i + 2, n - 1))];
    for (int s = 0; s < steps; ++s)
      out.push_back(catmull_rom(a, b, c, d, static_cast<float>(s) / static_cast<float>(steps)));
  }
  out.push_back(points.back());
  return out;
}

bool outside(const vec3& p, const vec3& low, const vec3& high, float reach, bool frontal) {
  if (p.x < low.x - reach || p.x > high.x + reach || p.y < low.y - reach || p.y > high.y + reach) return true;
  return !frontal && (p.z < low.z - reach || p.z > high.z + reach);
}

}  // namespace

std::vector<vec3> smooth_curve(const std::vector<vec3>& points, int steps) { return through(points, steps); }

Tube::Tube(const std::vector<Knot>& knots, int steps) {
  std::vector<glm::vec4> packed;
  for (const Knot& k : knots) packed.emplace_back(k.at, k.radius_mm);
  low_ = vec3(1e9f);
  high_ = vec3(-1e9f);
  for (const glm::vec4& k : through(packed, steps)) {
    knots_.push_back({vec3(k), k.w});
    low_ = glm::min(low_, vec3(k) - k.w);
    high_ = glm::max(high_, vec3(k) + k.w);
  }
}

float Tube::operator()(const vec3& p, float far_mm) const {
  const vec3 outside_by = glm::max(glm::max(low_ - p, p - high_), vec3(0));
  const float box_mm = glm::length(outside_by);
  if (box_mm >= far_mm) return box_mm;
  float best = 1e9f;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const vec3 ab = knots_[i + 1].at - knots_[i].at;
    const vec3 ap = p - knots_[i].at;
    const float t = std::clamp(glm::dot(ap, ab) / std::max(glm::dot(ab, ab), 1e-9f), 0.0f, 1.0f);
    const float radius = knots_[i].radius_mm + t * (knots_[i + 1].radius_mm - knots_[i].radius_mm);
    best = std::min(best, glm::length(ap - t * ab) - radius);
  }
  return best;
}

Stroke::Stroke(const std::vector<vec3>& points, const Brush& brush, int steps)
    : brush_(brush), points_(smooth_curve(points, steps)) {
  low_ = high_ = points_.front();
  for (const vec3& p : points_) {
    low_ = glm::min(low_, p);
    high_ = glm::max(high_, p);
  }
}

vec2 Stroke::nearest(const vec3& p, float reach_mm) const {
  if (outside(p, low_, high_, reach_mm, brush_.frontal)) return {1e3f, 0};
  float best2 = 1e6f, along = 0;
  const float pieces = static_cast<float>(points_.size() - 1);
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    vec3 ab = points_[i + 1] - points_[i];
    vec3 ap = p - points_[i];
    if (brush_.frontal) ab.z = ap.z = 0;
    const float t = std::clamp(glm::dot(ap, ab) / std::max(glm::dot(ab, ab), 1e-9f), 0.0f, 1.0f);
    const vec3 d = ap - t * ab;
    const float d2 = glm::dot(d, d);
    if (d2 < best2) {
      best2 = d2;
      along = (static_cast<float>(i) + t) / pieces;
    }
  }
  return {std::sqrt(best2), along};
}

float Stroke::operator()(const vec3& p) const {
  const vec2 n = nearest(p, brush_.radius_mm);
  if (n.x >= brush_.radius_mm) return 0;
  const float in = brush_.fade_start > 0 ? smooth_step(0, brush_.fade_start, n.y) : 1.0f;
  const float out = brush_.fade_end > 0 ? smooth_step(0, brush_.fade_end, 1.0f - n.y) : 1.0f;
  const float d = n.x / brush_.radius_mm;
  return brush_.amount_mm * in * out * falloff(d * d);
}

}  // namespace dermis::builtin_head
