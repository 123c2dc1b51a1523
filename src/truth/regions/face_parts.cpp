// SPDX-License-Identifier: MIT
#include "truth/regions/face_parts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>

#include "base/core/assert.h"

namespace dermis::regions {
namespace {

// Points in iBUG's order.
constexpr std::size_t jaw_points = 17;
constexpr std::array outer_lips{48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59};
constexpr std::array upper_parting{60, 61, 62, 63, 64}, lower_parting{60, 67, 66, 65, 64};
// Lips are no thicker; skin that lies deeper lines the mouth.
constexpr double lip_depth_m = 0.007;
constexpr int steps_per_point = 6;

/// Returns a closed curve through points (Catmull-Rom), as a polygon.
std::vector<glm::dvec2> smooth_outline(const std::vector<glm::dvec2>& points) {
  std::vector<glm::dvec2> outline;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 a = points[(i + n - 1) % n], b = points[i], c = points[(i + 1) % n],
                     d = points[(i + 2) % n];
    for (int k = 0; k < steps_per_point; ++k) {
      const double t = static_cast<double>(k) / steps_per_point;
      outline.push_back(0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                               t * t * t * (3.0 * b - a - 3.0 * c + d)));
    }
  }
  return outline;
}

/// Returns the distance to the border of a polygon, negative outside.
double inside(const std::vector<glm::dvec2>& polygon, const glm::dvec2& p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool is_in = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()], ab = b - a;
    const double length2 = glm::dot(ab, ab);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0;
    nearest = std::min(nearest, glm::distance(p, a + t * ab));
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * ab.x) is_in = !is_in;
  }
  return is_in ? nearest : -nearest;
}

/// Returns y at x of points whose x rises; level beyond both ends.
double interpolated(const std::vector<glm::dvec2>& points, double x) {
  const auto after = std::ranges::upper_bound(points, x, {}, &glm::dvec2::x);
  if (after == points.begin()) return points.front().y;
  if (after == points.end()) return points.back().y;
  const glm::dvec2 a = *(after - 1), b = *after;
  return std::lerp(a.y, b.y, (x - a.x) / (b.x - a.x));
}

std::vector<glm::dvec2> sorted_by_x(std::vector<glm::dvec2> points) {
  std::ranges::stable_sort(points, {}, &glm::dvec2::x);
  return points;
}

// Around a vertical axis, 0 to the front, +X positive.
double angle_of(const glm::dvec3& p, double x, double z) { return std::atan2(p.x - x, p.z - z); }

}  // namespace

FacePlaces::FacePlaces(std::span<const glm::dvec3> points_m) {
  DERMIS_ASSERT(points_m.size() >= 68);
  std::vector<glm::dvec2> outline;
  for (const int i : outer_lips) outline.emplace_back(points_m[static_cast<std::size_t>(i)]);
  outline_ = smooth_outline(outline);
  for (std::size_t i = outer_lips.front(); i < 68; ++i) lips_.push_back(points_m[i]);

  for (std::size_t k = 0; k < upper_parting.size(); ++k)
    parting_.emplace_back(0.5 * (points_m[static_cast<std::size_t>(upper_parting[k])] +
                                 points_m[static_cast<std::size_t>(lower_parting[k])]));
  parting_ = sorted_by_x(std::move(parting_));

  // The jaw line ends before the ears: the axis lies between its ends.
  middle_x_m_ = 0.5 * (points_m[0].x + points_m[16].x);
  axis_z_m_ = 0.5 * (points_m[0].z + points_m[16].z);
  for (std::size_t i = 0; i < jaw_points; ++i)
    jaw_.emplace_back(angle_of(points_m[i], middle_x_m_, axis_z_m_), points_m[i].y);
  jaw_ = sorted_by_x(std::move(jaw_));
  // Behind the ears the neck begins as low as their lobes.
  const double lobe_m = 0.5 * (points_m[2].y + points_m[14].y);
  jaw_.front().y = jaw_.back().y = lobe_m;
}

double FacePlaces::jaw_height_m(const glm::dvec3& p_m) const {
  return interpolated(jaw_, angle_of(p_m, middle_x_m_, axis_z_m_));
}

// Of the lips before a point: the mean of their points, the nearest most.
double FacePlaces::front_m(const glm::dvec2& p) const {
  double sum = 0, weights = 0;
  for (const glm::dvec3& lip : lips_) {
    const double distance = glm::distance(glm::dvec2(lip), p) + 1e-4;
    const double weight = 1 / (distance * distance * distance);
    sum += weight * lip.z;
    weights += weight;
  }
  return sum / weights;
}

FacePlace FacePlaces::at(const glm::dvec3& p_m) const {
  const double in_outline = inside(outline_, glm::dvec2(p_m));
  const double behind = front_m(glm::dvec2(p_m)) - p_m.z - lip_depth_m;
  return {.lips = static_cast<float>(std::min(in_outline, -behind)),
          .above_parting = static_cast<float>(p_m.y - interpolated(parting_, p_m.x)),
          .behind_lips = static_cast<float>(std::min(in_outline, behind)),
          .below_jaw = static_cast<float>(jaw_height_m(p_m) - p_m.y),
          .left = static_cast<float>(p_m.x - middle_x_m_)};
}

NamedPart named_part(std::string_view name) {
  std::string small;
  for (const char c : name) small += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  struct Rule {
    const char* word;
    NamedPart part;
  };
  constexpr Rule rules[] = {
      {"lash", NamedPart::lashes},  {"brow", NamedPart::brow},    {"teeth", NamedPart::mouth},
      {"tooth", NamedPart::mouth},  {"gum", NamedPart::mouth},    {"tongue", NamedPart::mouth},
      {"mouth", NamedPart::mouth},  {"eye", NamedPart::eye},      {"sclera", NamedPart::eye},
      {"iris", NamedPart::eye},     {"cornea", NamedPart::eye},   {"pupil", NamedPart::eye},
      {"caruncle", NamedPart::eye}, {"lacrimal", NamedPart::eye}, {"tear", NamedPart::eye},
      {"hair", NamedPart::hair},    {"beard", NamedPart::hair}};
  for (const Rule& rule : rules)
    if (small.find(rule.word) != std::string::npos) return rule.part;
  return NamedPart::none;
}

}  // namespace dermis::regions
