// SPDX-License-Identifier: MIT
// Relief of the skin that is smaller than the sculpture: pores, the net of
// furrows between them, and wrinkles where skin folds. Based on: [F15] Flament, Francois, Qiu et al.: Facial
// skin pores: a multiethnic study. Clinical, Cosmetic and Investigational Dermatology 8, 2015 (visible pores
// are wider than 0.25 mm) [O04] Otberg, Richter, Schaefer et al.: Variations of hair follicle size and
// distribution in different body sites. Journal of Investigative Dermatology 122, 2004 (292 follicles per
// cm^2 of forehead: of these, visible pores are a part) [B84] Borges: Relaxed skin tension lines versus other
// skin lines. Plastic and Reconstructive Surgery 73, 1984 (directions) [L01] Lemperle, Holmes, Cohen,
// Lemperle: A classification of facial wrinkles. Plastic and Reconstructive Surgery 108, 2001 (fine wrinkles
// are less than 0.2 mm deep)
#pragma once

#include "head/builtin_head/noise.h"
#include "head/builtin_head/region.h"

namespace dermis::builtin_head {

/// Returns the direction of the relaxed skin tension lines [B84] at a point of the symmetric face (x >= 0),
/// in the surface; shorter than 1 where lines meet.
vec3 tension_line(const vec3& symmetric_mm, const Region& where);

struct Relief {
  float height_mm = 0;  ///< over the sculpture
  float pore = 0;       ///< 0 beside pores, 1 in the deepest
};

/// Finds the relief of one texel after the other; neighbours cost least. Not shared between threads.
class ReliefWalk {
 public:
  Relief at(const vec3& p_mm, const Region& where);

 private:
  float lips_mm(const vec3& p_mm, const Region& where);
  float forehead_mm(const vec3& p_mm, const Region& where);
  float eyes_mm(const vec3& p_mm, const Region& where);
  float neck_mm(const vec3& p_mm, const Region& where);
  CellWalk pores_{101}, furrows_{103};
  NoiseWalk soft_{109}, fine_{113}, lip_wave_{127}, lip_fine_{131}, wander_{137}, broken_{139}, fan_{149},
      lower_lid_{151}, rings_{157}, creases_{163};
};

}  // namespace dermis::builtin_head
