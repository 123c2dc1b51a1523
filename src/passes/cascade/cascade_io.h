// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_CASCADE_IO_H
#define DERMIS_PASSES_CASCADE_IO_H
#include "passes/cascade_level_io.h"
#include "shared/types.h"
#define MOST_NARROW 4  // terms that one pass spreads
DERMIS_IO_BEGIN
struct CascadeIo {
  float variance_mm2;
  uint axis;            // 0, then 1
  uint texel_averaged;  // the light is that of texels, not yet blurred
  uvec2 origin;         // of the square in the pool
  uint side;            // its used part, texels
  uint square;          // number in the pool
  uint first_tile;      // of its tiles in the list
  vec3 scale;           // axis 1: multiplies the blurred light
  vec3 joins;           // axis 1: weight of the light that joins then
  // What moving between maps adds is taken off: by this step what is left by the first terms of the level,
  // times the share of its term that the step is.
  CascadeLevelIo level;
  uint terms_before;
  float share;
};
struct CascadeSumIo {
  uvec2 origin;
  uint side;
  uint square;
  uint first_tile;
  uint count;           // of narrow terms
  uint spread;          // 1: there are wide terms
  float last_step_mm2;  // their last step, of which the second axis is to be done; 0: none is
  vec3 scale;           // multiplies the light that it blurs
  vec3 joined;          // weight of narrow terms whose transmitted light is that of the second group
  float variance_mm2[MOST_NARROW];
  vec3 weights[MOST_NARROW];
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::CascadeIo) == 108);
static_assert(sizeof(dermis::io::CascadeSumIo) == 120);
#endif
#endif
