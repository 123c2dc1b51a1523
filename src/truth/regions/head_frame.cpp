// SPDX-License-Identifier: MIT
#include "truth/regions/head_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace dermis::regions {
namespace {

constexpr double head_height_mm = 260;

template <class Visit>
void for_each_skin_vertex(const scene::AssetData& scene, const Visit& visit) {
  for (const scene::Primitive& p : scene.primitives)
    if (rays::is_skin(scene, p))
      for (const std::uint32_t index : p.indices) visit(glm::dvec3(p.vertices[index].position_m));
}

/// Returns the depth behind the tip of the skin seen from the front at an offset (half breadths); infinity if
/// there is none.
double depth_behind(const rays::RayScene& rays, const glm::dvec3& tip_m, double half_breadth_m,
                    const glm::dvec2& offset) {
  const glm::dvec3 above = tip_m + half_breadth_m * glm::dvec3(offset, 1);
  const auto hit = rays.nearest_skin({.origin_m = above, .direction = {0, 0, -1}});
  return hit ? hit->t_m / half_breadth_m - 1 : std::numeric_limits<double>::infinity();
}

// Cheeks lie 20 mm or more behind the tip of a nose, its root 15 mm; a ball of the head's size falls off by 4
// mm at this offset. Holes are excluded, too.
bool is_nose(const rays::RayScene& rays, const glm::dvec3& tip_m, double half_breadth_m) {
  const auto deep = [&](const glm::dvec2& offset, double least) {
    const double depth = depth_behind(rays, tip_m, half_breadth_m, offset);
    return depth > least && depth < 1;
  };
  return deep({-0.28, 0}, 0.1) && deep({0.28, 0}, 0.1) && deep({0, 0.45}, 0.07);
}

/// Returns the length that `part` of the rays in a cone of 60 degrees around the axis do not exceed before
/// they meet skin.
double way_m(const rays::RayScene& rays, const rays::SurfacePoint& s, const glm::dvec3& axis, double part) {
  constexpr std::size_t count = 24;
  constexpr double cos_cone = 0.5;
  const glm::dvec3 across =
      glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 third = glm::cross(axis, across);
  const double gap = rays::stand_off_m(s.position_m);

  std::array<double, count> ways{};
  for (std::size_t i = 0; i < count; ++i) {
    // A spiral by the golden angle, uniform in solid angle.
    const double cosine = 1 - (1 - cos_cone) * (static_cast<double>(i) + 0.5) / count,
                 sine = std::sqrt(1 - cosine * cosine);
    const double angle = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0));
    const glm::dvec3 direction = cosine * axis + sine * (std::cos(angle) * across + std::sin(angle) * third);
    const auto hit =
        rays.nearest_skin({.origin_m = s.position_m + gap * axis, .direction = direction, .t_min_m = gap});
    ways[i] = hit ? hit->t_m : std::numeric_limits<double>::infinity();
  }

  const auto nth = ways.begin() + static_cast<std::ptrdiff_t>(part * count);
  std::nth_element(ways.begin(), nth, ways.end());
  return *nth;
}

}  // namespace

std::optional<HeadFrame> HeadFrame::find(const rays::RayScene& rays) {
  const scene::AssetData& scene = rays.scene();
  double top_m = -1e300;
  for_each_skin_vertex(scene, [&](const glm::dvec3& p) { top_m = std::max(top_m, p.y); });

  HeadFrame frame;
  frame.tip_m_.z = -1e300;
  const double lowest_m = top_m - head_height_mm / scene.mm_per_unit;
  for_each_skin_vertex(scene, [&](const glm::dvec3& p) {
    if (p.y >= lowest_m && p.z > frame.tip_m_.z) frame.tip_m_ = p;
  });

  // The breadth at the height of the nose and above: ears stand out there, and shoulders are far below.
  for_each_skin_vertex(scene, [&](const glm::dvec3& p) {
    if (p.y >= frame.tip_m_.y && p.y <= top_m)
      frame.half_breadth_m_ = std::max(frame.half_breadth_m_, std::abs(p.x - frame.tip_m_.x));
  });

  if (!(frame.half_breadth_m_ > 0) || !is_nose(rays, frame.tip_m_, frame.half_breadth_m_))
    return std::nullopt;
  return frame;
}

double HeadFrame::inside_nose(const glm::dvec3& position_m) const {
  // From between the wings to the root, where the ridge is narrow.
  const glm::dvec3 low(0, -0.03, -0.14), high(0, 0.42, -0.24);
  constexpr double low_radius = 0.22, high_radius = 0.12;
  const glm::dvec3 p = in_half_breadths(position_m);
  const double along = std::clamp(glm::dot(p - low, high - low) / glm::dot(high - low, high - low), 0.0, 1.0);
  return std::lerp(low_radius, high_radius, along) - glm::distance(p, glm::mix(low, high, along));
}

double HeadFrame::inside_sides(const glm::dvec3& position_m) const {
  const glm::dvec3 p = in_half_breadths(position_m);
  return std::min({std::abs(p.x) - 0.6, p.y + 0.35, 0.9 - p.y, -0.7 - p.z});
}

double thickness_m(const rays::RayScene& rays, const rays::SurfacePoint& s) {
  return way_m(rays, s, -s.face_normal, 0.5);
}

double gap_m(const rays::RayScene& rays, const rays::SurfacePoint& s) {
  return way_m(rays, s, s.face_normal, 0.25);
}

}  // namespace dermis::regions
