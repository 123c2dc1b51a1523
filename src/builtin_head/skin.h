// SPDX-License-Identifier: MIT
// The painter: the look of the skin at a point of the bust's surface.
#pragma once

#include "builtin_head/complexion.h"
#include "builtin_head/hair.h"
#include "builtin_head/sculpture.h"

namespace dermis::builtin_head {

struct SkinPoint {
  vec3 albedo{0.5f};       ///< linear Rec.709, 0..1
  float specular = 1;      ///< multiplies rho_s, 0..1
  float roughness = 0.5f;  ///< glTF roughness (m = roughness^2)
};

/// The position of a point on the face; all 0..1 unless said otherwise. Varies over millimetres, so it is
/// computed on a net and interpolated.
struct Region {
  vec3 symmetric{0};  ///< mm; x keeps its sign (left is positive), the painter takes |x|
  float lips = 0, cheek = 0, nose_tip = 0, nose = 0, ear = 0, forehead = 0, t_zone = 0;
  float under_eye = 0, upper_lid = 0, beard = 0, scalp = 0, neck = 0, crow = 0, chin = 0;
  float complexion = 0;  ///< about -1..1: broad unevenness of the colour
};
/// Returns a (1 - t) + b t for every member.
Region blend(const Region& a, const Region& b, float t);

class Skin {
 public:
  Skin(const Sculpture& bust, const Complexion& complexion);
  Region region(const vec3& p_mm) const;
  SkinPoint paint(const vec3& p_mm, const Region& where) const;
  /// Returns the height of pores and fine lines over the sculpted surface, mm.
  float relief_mm(const vec3& p_mm, const Region& where) const;

 private:
  vec3 tint(const vec3& p_mm, const Region& where) const;
  float lip_mask(const vec3& q) const;
  float hair(const vec3& p_mm, const vec3& symmetric) const;
  vec3 lip_colour(const vec3& p_mm) const;
  Complexion complexion_;
  const optics::SkinTable& table_;
  Frame ear_;
  Hairs hairs_;
  Stroke lash_, brow_, mouth_;
  std::vector<vec3> upper_lip_, lower_lip_;
};

}  // namespace dermis::builtin_head
