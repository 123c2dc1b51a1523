// SPDX-License-Identifier: MIT
// The bust as a field: skull, face, ears and neck put together. Millimetres; y from the line of the eyes, z
// from the middle of the head, looking along +z.
#pragma once

#include "head/builtin_head/clay.h"
#include "head/builtin_head/skull.h"

namespace dermis::builtin_head {

/// blunt: without hollows, so that a coarse net can be drawn over it. form: detail that a mesh of 25,000
/// triangles can show. fine: adds creases narrower than its triangles, for the normal map.
enum class Detail { blunt, form, fine };

/// Brow, orbits, closed eyes, nose, lips, cheeks and chin. Works on the mirrored half (x >= 0, rounded at 0).
class Face {
 public:
  Face();
  float add(float f, const vec3& p, Detail detail) const;

 private:
  float add_planes(float f, const vec3& p) const;
  float add_eye(float f, const vec3& p, Detail detail) const;
  float add_nose(float f, const vec3& p, Detail detail) const;
  float add_mouth(float f, const vec3& p, Detail detail) const;
  std::vector<Dab> planes_;
  std::vector<Stroke> folds_, lid_strokes_, lid_creases_, nose_strokes_, mouth_strokes_, mouth_creases_;
  Tube bridge_, nose_core_, columella_, ala_, upper_lip_, lower_lip_;
  Frame eye_, nostril_;
};

/// One ear, modelled in its own frame: x from the cheek to the rear rim, y up along its axis, z outwards.
class Ear {
 public:
  Ear();
  float add(float f, const vec3& p, Detail detail) const;
  const Frame& frame() const { return frame_; }

 private:
  Frame frame_;
  Tube helix_, antihelix_, inferior_crus_, lobe_rim_;
  std::vector<Dab> hollows_;
};

/// Neck and the start of the shoulders.
class Neck {
 public:
  Neck();
  float mass(const vec3& p) const;
  float add_muscles(float f, const vec3& p) const;

 private:
  std::vector<Stroke> strokes_;
  std::vector<Dab> dabs_;
  Tube shoulder_, clavicle_;
};

class Sculpture {
 public:
  static constexpr float eyes_over_origin_mm = 35;  ///< where the line of the eyes lies in the scene
  /// Returns the height of the cut that closes the bust below, as a collar runs: lowest over the breastbone,
  /// rising over the shoulders.
  static float cut_mm(float x, float z) { return -207.0f - 0.20f * (z - 10.0f) + 0.0018f * x * x; }
  float field(const vec3& p, Detail detail) const;
  /// Returns the same with shoulders that continue below the cut.
  float uncut(const vec3& p, Detail detail) const;
  /// Moves p onto the surface along the gradient, `steps` Newton steps; returns the unit normal of the last
  /// one.
  vec3 project(vec3& p, Detail detail, float step_mm, int steps) const;
  /// Moves a point of the symmetric face along z onto the form, coming from the front; it must be within 14
  /// mm.
  vec3 onto_skin(vec3 symmetric_mm) const;
  const Frame& ear_frame() const { return ear_.frame(); }

 private:
  Skull skull_;
  Face face_;
  Ear ear_;
  Neck neck_;
};

/// Returns the point of the symmetric bust for a point of the bust, which has the small asymmetry of every
/// face.
vec3 to_symmetric(const vec3& p);
/// Returns its inverse, within 0.01 mm.
vec3 from_symmetric(const vec3& q);
/// Returns |x| without its crease.
inline float mirrored(float x) { return std::sqrt(x * x + 0.36f); }

}  // namespace dermis::builtin_head
