// SPDX-License-Identifier: MIT
// The painter: the look of the skin at a point of the bust's surface.
#pragma once

#include "head/builtin_head/complexion.h"
#include "head/builtin_head/hair.h"
#include "head/builtin_head/relief.h"
#include "head/builtin_head/sculpture.h"
#include "head/builtin_head/tints.h"

namespace dermis::builtin_head {

struct SkinPoint {
  vec3 albedo{0.5f};       ///< linear Rec.709, 0..1
  float specular = 1;      ///< multiplies rho_s, 0..1
  float roughness = 0.5f;  ///< glTF roughness (m = roughness^2)
  float height_mm = 0;     ///< of pores and fine lines over the sculpted surface
};

/// Memory of a walk over texels, of their neighbours. Not shared between threads.
struct SkinWalk {
  ReliefWalk relief;
  NoiseWalk grain{9}, streak{81};
  CellWalk freckles[2] = {CellWalk(41), CellWalk(42)}, stubble{61}, crop[2] = {CellWalk(63), CellWalk(64)};
};

class Skin {
 public:
  Skin(const Sculpture& bust, const Complexion& complexion);
  Region region(const vec3& p_mm) const;
  SkinPoint paint(const vec3& p_mm, const Region& where, SkinWalk& walk) const;

 private:
  vec3 tint(const vec3& p_mm, const Region& where, float pore, SkinWalk& walk) const;
  float crop(const vec3& p_mm, const Region& where, SkinWalk& walk) const;
  float lip_mask(const vec3& q) const;
  float hair(const vec3& p_mm, const vec3& symmetric) const;
  Tints skin_, lips_;
  vec3 hair_colour_;
  Frame ear_;
  Hairs hairs_;
  Stroke lash_, brow_, mouth_;
  std::vector<vec3> upper_lip_, lower_lip_;
};

}  // namespace dermis::builtin_head
