// SPDX-License-Identifier: MIT
#include "head/builtin_head/sculpture.h"

namespace dermis::builtin_head {

vec3 to_symmetric(const vec3& p) {
  vec3 q = p;
  const float face = smooth_step(-20, 60, p.z);
  // one eye and one corner of the mouth a little higher
  q.y += face * (0.012f * p.x + 0.8f * std::sin(0.035f * p.x + 0.6f));
  // nose and chin a hair off the midline
  q.x += face * (0.9f * std::sin(0.024f * p.y + 0.4f) - 0.3f);
  q.z += 0.010f * p.x * face;
  return q;
}

vec3 from_symmetric(const vec3& q) {
  vec3 p = q;
  for (int k = 0; k < 4; ++k) p = q - (to_symmetric(p) - p);
  return p;
}

float Sculpture::field(const vec3& p, Detail detail) const {
  return soft_max(uncut(p, detail), 0.96f * (cut_mm(p.x, p.z) - p.y), 4.0f);
}

float Sculpture::uncut(const vec3& p, Detail detail) const {
  vec3 q = to_symmetric(p);
  q.x = mirrored(q.x);
  float f = skull_(q);
  if (q.z > -5.0f && q.y < 71.0f && q.y > -135.0f) f = face_.add(f, q, detail);
  if (q.y < 4.0f) f = soft_min(f, neck_.mass(q), 13.0f + 9.0f * smooth_step(10, -50, q.z));
  f = neck_.add_muscles(f, q);
  return ear_.add(f, q, detail);
}

vec3 Sculpture::project(vec3& p, Detail detail, float step_mm, int steps) const {
  vec3 g(0, 0, 1);
  for (int i = 0; i < steps; ++i) {
    // Gradient from the corners of a tetrahedron; their mean is the field at its centre, so one step costs
    // four samples.
    const float h = step_mm;
    const float a = field(p + vec3(h, -h, -h), detail), b = field(p + vec3(-h, -h, h), detail);
    const float c = field(p + vec3(-h, h, -h), detail), d = field(p + vec3(h, h, h), detail);
    g = vec3(a - b - c + d, -a - b + c + d, -a + b - c + d) / (4.0f * h);
    const float g2 = std::max(glm::dot(g, g), 0.05f);
    const float f = 0.25f * (a + b + c + d);
    p -= g * std::clamp(f / g2, -4.0f, 4.0f);
  }
  return glm::normalize(g);
}

vec3 Sculpture::onto_skin(vec3 q) const {
  float outside = q.z + 14.0f, inside = q.z - 14.0f;
  for (float z = outside; z > inside; z -= 0.7f) {
    if (field(from_symmetric({q.x, q.y, z}), Detail::form) > 0) {
      outside = z;
    } else {
      inside = z;
      break;
    }
  }
  for (int k = 0; k < 12; ++k) {
    q.z = 0.5f * (inside + outside);
    (field(from_symmetric(q), Detail::form) < 0 ? inside : outside) = q.z;
  }
  return q;
}

}  // namespace dermis::builtin_head
