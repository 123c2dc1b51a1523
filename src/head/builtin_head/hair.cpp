// SPDX-License-Identifier: MIT
#include "head/builtin_head/hair.h"

#include "head/builtin_head/landmarks.h"
#include "head/builtin_head/noise.h"

namespace dermis::builtin_head {
namespace {

constexpr float widest_mm = 0.5f;  // reach of a hair around its middle, edge included

// Random numbers for hair `n` of a kind: the same on every run.
struct Dice {
  int n, kind;
  float operator()(int which) const { return unit(lattice_hash(n, which, kind, 911)); }
};

vec2 point_on(const std::vector<vec3>& curve, float t) {
  const float x = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(curve.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), curve.size() - 2);
  return glm::mix(vec2(curve[i]), vec2(curve[i + 1]), x - static_cast<float>(i));
}

}  // namespace

Hairs::Hairs() {
  for (const float side : {1.0f, -1.0f}) { add_brow(side); }
  sort_into_buckets();
}

void Hairs::add(const vec2& root, float angle, float turn, float length_mm, float width_mm) {
  constexpr int parts = 4;
  vec2 at = root;
  for (int k = 0; k < parts; ++k) {
    const float t0 = static_cast<float>(k) / parts, t1 = static_cast<float>(k + 1) / parts;
    const float a = angle + turn * (t0 + 0.5f / parts);
    const vec2 next = at + vec2(std::cos(a), std::sin(a)) * (length_mm / parts);
    pieces_.push_back({at, next, width_mm * (1 - 0.8f * t0 * t0), width_mm * (1 - 0.8f * t1 * t1)});
    at = next;
  }
}

// Upright beside the nose, then outwards along the arch; hairs of the upper edge lean down, those of the
// lower one up, and meet in a ridge.
void Hairs::add_brow(float side) {
  const std::vector<vec3> curve = smooth_curve(brow_line, 8);
  for (int n = 0; n < 640; ++n) {
    const Dice dice{n, side > 0 ? 1 : 2};
    const float t = 0.98f * std::pow(dice(0), 0.9f) - 0.05f + 0.06f * dice(6);
    const vec2 middle = point_on(curve, t), ahead = point_on(curve, std::min(t + 0.04f, 1.0f)) -
                                                    point_on(curve, std::max(t - 0.04f, 0.0f));

    // Sparse at its inner end, which is no edge.
    if (dice(8) > 0.35f + 0.65f * smooth_step(-0.02f, 0.22f, t)) continue;
    const float half = 4.9f * (1 - 0.62f * t) * smooth_step(-0.25f, 0.22f, t);
    const float offset = (dice(1) + dice(2) - 1.0f) * half * 1.05f - 0.4f;
    const float flow = std::atan2(ahead.y, ahead.x);
    const float upright = 1.25f * (1 - smooth_step(0.0f, 0.38f, t));
    float angle =
        flow + upright + 0.10f - 0.17f * offset * smooth_step(0.10f, 0.5f, t) + 0.30f * (dice(3) - 0.5f);
    float turn = -0.45f * upright - 0.25f * dice(4);

    vec2 root = middle + vec2(0, offset);
    const float length =
        (5.0f + 3.2f * dice(5)) * (1 - 0.35f * t) * (0.75f + 0.25f * smooth_step(0, 0.15f, t));
    root -= 0.35f * length * vec2(std::cos(angle), std::sin(angle));

    if (side < 0) {
      root.x = -root.x;
      angle = 3.14159265f - angle;
      turn = -turn;
    }

    add(root, angle, turn, length, 0.07f + 0.07f * dice(7));
  }
}

void Hairs::sort_into_buckets() {
  std::vector<std::vector<std::uint32_t>> lists(static_cast<std::size_t>(buckets_x * buckets_y));
  const auto cell = [](float at, float first, int count) {
    return std::clamp(static_cast<int>((at - first) / bucket_mm), 0, count - 1);
  };

  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const vec2 low = glm::min(pieces_[k].from, pieces_[k].to) - widest_mm,
               high = glm::max(pieces_[k].from, pieces_[k].to) + widest_mm;
    for (int j = cell(low.y, bottom_mm, buckets_y); j <= cell(high.y, bottom_mm, buckets_y); ++j) {
      for (int i = cell(low.x, left_mm, buckets_x); i <= cell(high.x, left_mm, buckets_x); ++i) {
        lists[static_cast<std::size_t>(j * buckets_x + i)].push_back(static_cast<std::uint32_t>(k));
      }
    }
  }

  // Packs the lists: bucket k is order_[start_[k]] up to order_[start_[k + 1]].
  start_.push_back(0);
  for (const auto& list : lists) {
    order_.insert(order_.end(), list.begin(), list.end());
    start_.push_back(static_cast<std::uint32_t>(order_.size()));
  }
}

float Hairs::coverage(const vec2& at, float softness_mm) const {
  const int i = static_cast<int>(std::floor((at.x - left_mm) / bucket_mm)),
            j = static_cast<int>(std::floor((at.y - bottom_mm) / bucket_mm));
  if (i < 0 || j < 0 || i >= buckets_x || j >= buckets_y) return 0;
  const std::size_t bucket = static_cast<std::size_t>(j * buckets_x + i);
  float bare = 1;
  for (std::uint32_t k = start_[bucket]; k < start_[bucket + 1]; ++k) {
    const Piece& piece = pieces_[order_[k]];
    const vec2 ab = piece.to - piece.from, ap = at - piece.from;
    const float t = std::clamp(glm::dot(ap, ab) / glm::dot(ab, ab), 0.0f, 1.0f);
    const float half = 0.5f * glm::mix(piece.width_from_mm, piece.width_to_mm, t);
    // A hair thinner than a texel keeps its weight: it is drawn one texel wide, but fainter.
    const float edge = std::max(half, 0.5f * softness_mm), strength = half / edge;
    bare *= 1 - 0.9f * strength *
                    (1 - smooth_step(edge - 0.5f * softness_mm, edge + 0.5f * softness_mm,
                                     glm::length(ap - t * ab)));
  }
  return 1 - bare;
}

}  // namespace dermis::builtin_head
