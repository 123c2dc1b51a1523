// SPDX-License-Identifier: MIT
// Tools to sculpt the built-in head: soft unions, a few volumes, and brush strokes that raise or press the
// surface. All lengths are millimetres; a field is negative inside and grows by about one per millimetre
// outwards.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace dermis::builtin_head {

using glm::vec2;
using glm::vec3;
using glm::vec4;

/// Returns the union with a fillet about `k` wide (quadratic polynomial: smooth, local, exact outside the
/// fillet).
inline float soft_min(float a, float b, float k_mm) {
  const float h = std::max(k_mm - std::abs(a - b), 0.0f) / k_mm;
  return std::min(a, b) - h * h * k_mm * 0.25f;
}
inline float soft_max(float a, float b, float k_mm) { return -soft_min(-a, -b, k_mm); }

/// Returns 1 at the centre and 0 from distance 1 on, twice differentiable; `d2` is the squared distance in
/// units of the radius.
inline float falloff(float d2) {
  const float w = std::max(1.0f - d2, 0.0f);
  return w * w * w;
}

/// Returns exp(-x); far out without the library's way to a number that is too small.
inline float faded(float x) { return x > 104.0f ? 0.0f : std::exp(-x); }

inline float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// Returns the approximate distance to an ellipsoid about the origin.
inline float ellipsoid(const vec3& p, const vec3& radii_mm) {
  const vec3 q = p / radii_mm;
  const float k0 = glm::length(q);
  const float k1 = glm::length(q / radii_mm);
  return k1 > 1e-6f ? k0 * (k0 - 1.0f) / k1 : -std::min({radii_mm.x, radii_mm.y, radii_mm.z});
}

/// A right-handed frame in which a part is modelled.
struct Frame {
  vec3 origin{0};
  vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  vec3 to_local(const vec3& p) const {
    const vec3 d = p - origin;
    return {glm::dot(d, x), glm::dot(d, y), glm::dot(d, z)};
  }
};

/// Raises (amount > 0) or presses the surface around a point.
struct Dab {
  vec3 centre{0};
  vec3 radii_mm{1};
  float amount_mm = 0;
  float operator()(const vec3& p) const {
    const vec3 d = p - centre;
    // Most points are far from most dabs, and divisions take longest.
    if (std::abs(d.y) >= radii_mm.y || std::abs(d.x) >= radii_mm.x) return 0;
    const vec3 q = d / radii_mm;
    return amount_mm * falloff(glm::dot(q, q));
  }
};

/// A node of a tube: centre and radius.
struct Knot {
  vec3 at{0};
  float radius_mm = 1;
};

/// A box about some pieces of a curve, so that far ones are passed over; does not change a result.
struct PieceBox {
  std::size_t first = 0, last = 0;  ///< pieces
  vec3 low{0}, high{0};
};

/// A tube of varying radius along a smooth curve through its knots.
class Tube {
 public:
  explicit Tube(const std::vector<Knot>& knots, int steps = 5);
  /// Returns the distance to the tube's surface; `far_mm` or more if p is that far outside the tube's box. A
  /// union with a field f and a fillet k needs it up to f + k.
  float operator()(const vec3& p, float far_mm) const;

 private:
  struct Piece {
    vec3 from{0}, along{0};
    float along2 = 0;  ///< squared length, not 0
    float radius_mm = 0, widens_mm = 0;
  };
  std::vector<Piece> pieces_;
  std::vector<PieceBox> boxes_;
  vec3 low_{0}, high_{0};
};

/// A stroke of the brush or of the knife along a smooth curve: amount * falloff(distance), faded towards the
/// ends.
class Stroke {
 public:
  struct Brush {
    float radius_mm = 1;
    float amount_mm = 0;       ///< > 0 raises, < 0 presses
    float fade_start = 0.25f;  ///< part of the length over which the stroke fades in
    float fade_end = 0.25f;    ///< and fades out
    /// distances are measured in x and y only (features on the face), else in space
    bool frontal = true;
  };
  Stroke(const std::vector<vec3>& points, const Brush& brush, int steps = 6);
  float operator()(const vec3& p) const;
  /// Returns the distance to the curve [mm], and the position of the nearest point along it (0..1); the
  /// distance is 1e3 if it is over reach_mm.
  vec2 nearest(const vec3& p, float reach_mm) const;

 private:
  Brush brush_;
  struct Piece {
    vec3 from{0}, along{0};
    float along2 = 0;  ///< squared length, not 0; without z if the brush is frontal
  };
  std::vector<Piece> pieces_;
  std::vector<PieceBox> boxes_;
  vec3 low_{0}, high_{0};
};

/// Returns a curve through the points (uniform Catmull-Rom, which suffices for evenly spaced points), `steps`
/// pieces per span.
std::vector<vec3> smooth_curve(const std::vector<vec3>& points, int steps);

}  // namespace dermis::builtin_head
