// SPDX-License-Identifier: MIT
#include "head/builtin_head/clay.h"

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

// Boxes of `per_box` pieces between points, each grown by the points' radii.
template <class At, class Radius>
std::vector<PieceBox> boxes_of(std::size_t pieces, std::size_t per_box, const At& at, const Radius& radius) {
  std::vector<PieceBox> boxes;
  for (std::size_t first = 0; first < pieces; first += per_box) {
    PieceBox box{first, std::min(first + per_box, pieces), vec3(1e9f), vec3(-1e9f)};
    for (std::size_t k = box.first; k <= box.last; ++k) {
      box.low = glm::min(box.low, at(k) - radius(k));
      box.high = glm::max(box.high, at(k) + radius(k));
    }
    boxes.push_back(box);
  }
  return boxes;
}

vec3 outside_box(const vec3& p, const vec3& low, const vec3& high) {
  return glm::max(glm::max(low - p, p - high), vec3(0));
}

}  // namespace

std::vector<vec3> smooth_curve(const std::vector<vec3>& points, int steps) { return through(points, steps); }

Tube::Tube(const std::vector<Knot>& knots, int steps) {
  std::vector<vec4> packed;
  for (const Knot& k : knots) packed.emplace_back(k.at, k.radius_mm);
  low_ = vec3(1e9f);
  high_ = vec3(-1e9f);
  std::vector<Knot> fine;
  for (const vec4& k : through(packed, steps)) {
    fine.push_back({vec3(k), k.w});
    low_ = glm::min(low_, vec3(k) - k.w);
    high_ = glm::max(high_, vec3(k) + k.w);
  }
  for (std::size_t k = 0; k + 1 < fine.size(); ++k) {
    const vec3 ab = fine[k + 1].at - fine[k].at;
    pieces_.push_back({fine[k].at, ab, std::max(glm::dot(ab, ab), 1e-9f), fine[k].radius_mm,
                       fine[k + 1].radius_mm - fine[k].radius_mm});
  }
  boxes_ = boxes_of(
      pieces_.size(), static_cast<std::size_t>(steps), [&](std::size_t k) { return fine[k].at; },
      [&](std::size_t k) { return vec3(fine[k].radius_mm); });
}

float Tube::operator()(const vec3& p, float far_mm) const {
  const float box_mm = glm::length(outside_box(p, low_, high_));
  if (box_mm >= far_mm) return box_mm;
  float best = 1e9f;
  for (const PieceBox& box : boxes_) {
    const vec3 by = outside_box(p, box.low, box.high);
    if (best < 0 ? by != vec3(0) : glm::dot(by, by) > best * best) continue;
    for (std::size_t i = box.first; i < box.last; ++i) {
      const Piece& piece = pieces_[i];
      const vec3 ap = p - piece.from;
      const float t = std::clamp(glm::dot(ap, piece.along) / piece.along2, 0.0f, 1.0f);
      best = std::min(best, glm::length(ap - t * piece.along) - (piece.radius_mm + t * piece.widens_mm));
    }
  }
  return best;
}

Stroke::Stroke(const std::vector<vec3>& points, const Brush& brush, int steps) : brush_(brush) {
  const std::vector<vec3> curve = smooth_curve(points, steps);
  low_ = high_ = curve.front();
  for (const vec3& p : curve) {
    low_ = glm::min(low_, p);
    high_ = glm::max(high_, p);
  }
  for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
    vec3 ab = curve[k + 1] - curve[k];
    if (brush_.frontal) ab.z = 0;
    pieces_.push_back({curve[k], ab, std::max(glm::dot(ab, ab), 1e-9f)});
  }
  boxes_ = boxes_of(
      pieces_.size(), static_cast<std::size_t>(steps), [&](std::size_t k) { return curve[k]; },
      [](std::size_t) { return vec3(0); });
}

vec2 Stroke::nearest(const vec3& p, float reach_mm) const {
  if (outside(p, low_, high_, reach_mm, brush_.frontal)) return {1e3f, 0};
  float best2 = reach_mm * reach_mm, along = 0;
  bool found = false;
  const float pieces = static_cast<float>(pieces_.size());
  for (const PieceBox& box : boxes_) {
    vec3 by = outside_box(p, box.low, box.high);
    if (brush_.frontal) by.z = 0;
    if (glm::dot(by, by) > best2) continue;
    for (std::size_t i = box.first; i < box.last; ++i) {
      const Piece& piece = pieces_[i];
      vec3 ap = p - piece.from;
      if (brush_.frontal) ap.z = 0;
      const float t = std::clamp(glm::dot(ap, piece.along) / piece.along2, 0.0f, 1.0f);
      const vec3 d = ap - t * piece.along;
      const float d2 = glm::dot(d, d);
      if (d2 < best2) {
        best2 = d2;
        along = (static_cast<float>(i) + t) / pieces;
        found = true;
      }
    }
  }
  return found ? vec2(std::sqrt(best2), along) : vec2(1e3f, 0);
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
