// SPDX-License-Identifier: MIT
// How much more or less light leaves than from a flat half-space: curved_total(), slab_front() and
// exit_factor() of profile/shape_laws.h. Needs `terms` (SkinTermsIo).

// shape: mean and half difference of the principal curvatures per mm, thickness in mm. cosine: of the angle
// of exit.
vec3 shape_factor(vec3 shape, float cosine) {
  const vec3 bend = shape.x > 0.0 ? terms.shape.convex_mm : -terms.shape.concave_mm;
  const vec3 below = max(1.0 + bend * shape.x + terms.shape.difference_mm * shape.y, 0.5);
  const vec3 total = clamp(
      1.0 + terms.shape.curvature_mm * shape.x / below + terms.shape.difference_mm2 * (shape.y * shape.y),
      0.3, 2.5);
  const vec3 front = 1.0 - terms.shape.front_share * exp(-shape.z * terms.shape.front_per_mm);
  const float c = clamp(cosine, 0.0, 1.0);
  return total * front * (terms.shape.exit_grazing + terms.shape.exit_change * (c * c));
}
