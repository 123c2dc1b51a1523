// SPDX-License-Identifier: MIT
// Moving light to smaller maps and back blurs it, where skin has few texels by more than the terms that are
// blurred there: what their steps cannot take off is left. Needs `io.level`, a CascadeLevelIo.
#include "passes/cascade_level_io.h"

// How far 1 mm reaches, of the texels of this map.
struct TexelsPerMm {
  float least2;  // squared, in the direction in which it is the fewest
  float both2;   // the sum of squares along u and v
};

// l: texels along u, (u, v): the Cholesky factor of the inverse metric.
TexelsPerMm texels_per_mm(vec3 l) {
  const float uu = l.x * l.x, uv = l.x * l.y, vv = l.y * l.y + l.z * l.z;
  const float mean = 0.5 * (uu + vv), det = max(uu * vv - uv * uv, 0.0);
  return TexelsPerMm(det / max(mean + sqrt(max(mean * mean - det, 0.0)), 1e-20), 2.0 * mean);
}

// Returns the part of a variance along u and v that can be taken off a step.
float taken_off(float due, float step_mm2, TexelsPerMm texels) {
  return min(due, 0.98 * step_mm2 * texels.least2);
}

// Returns what the first `count` terms of the level leave, texels^2 of this map.
float left_after(uint count, TexelsPerMm texels) {
  float left = io.level.moved_texels2;
  for (uint i = 0; i < count; ++i) left -= taken_off(left, io.level.steps_mm2[i], texels);
  return left;
}

// Returns how much of the light of a level is taken from there; the rest is taken from light that has not
// spread. Together they are as wide as the terms should be, in the mean distance along an axis (sigma, which
// an edge shows, and not variance: a wide and a narrow Gaussian of the right variance miss an edge by twice
// as much). The mean over the terms of the level, by their weights.
float held_by_level(TexelsPerMm texels) {
  const float narrow2 = io.level.before_mm2 * 0.5 * texels.both2, narrow = sqrt(narrow2);
  float left = io.level.moved_texels2, step_mm2 = 0.0, wanted = 0.0, found = 0.0;
  for (uint i = 0; i < io.level.terms; ++i) {
    left -= taken_off(left, io.level.steps_mm2[i], texels);
    step_mm2 += io.level.steps_mm2[i];
    const float variance = narrow2 + step_mm2 * 0.5 * texels.both2;
    wanted += io.level.weights[i] * (sqrt(variance) - narrow);
    found += io.level.weights[i] * (sqrt(variance + left) - narrow);
  }
  return found > 0.0 ? wanted / found : 1.0;
}
