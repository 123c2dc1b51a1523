// SPDX-License-Identifier: MIT
#include "head/builtin_head/relief.h"

namespace dermis::builtin_head {
namespace {

// Cells per mm of the pores. Balls of radius r about one point per cell meet the surface in scale^3 2 r
// circles per mm^2. Where a pore is deeper than 30 % of its depth, r is 0.64 of its radius: 1.5^3 x 2 x 0.19
// mm = 128 per cm^2.
constexpr float pores_per_mm = 1.5f;
// A cell drawn out by 1 / sqrt(1 - 0.6^2) = 1.25 along the tension lines.
constexpr float drawn_out = 0.6f;

// A crease where `wave` crosses zero, 1 at its bottom.
float crease(float wave, float width) { return 1 - smooth_step(0.0f, width, std::abs(wave)); }

}  // namespace

vec3 tension_line(const vec3& q, const Region& r) {
  // Directions have no sign, so their doubled angles are averaged.
  vec2 sum(0);
  const auto add = [&](float angle, float weight) {
    sum += weight * vec2(std::cos(2 * angle), std::sin(2 * angle));
  };

  // Across forehead, nose and neck; down and outwards over the cheek; rays from eye and mouth.
  add(0.0f, 0.3f + r.forehead + r.nose + 2 * r.neck);
  const float side = smooth_step(20, 50, q.x) * smooth_step(10, -20, q.y) * (1 - r.neck);
  add(-1.05f, 1.5f * std::max(side, r.cheek));
  add(std::atan2(q.y + 2.0f, q.x - 38.0f), 3 * r.crow);
  add(0.0f, 2 * r.under_eye);
  const vec2 from_mouth(q.x / 1.6f, q.y + 69.0f);
  const float mouth = std::exp(-glm::dot(from_mouth, from_mouth) / 250.0f);
  add(std::atan2(1.5f * from_mouth.y, from_mouth.x), 4 * mouth * smooth_step(60, 80, q.z));

  const float angle = 0.5f * std::atan2(sum.y, sum.x);
  const float strength = std::min(1.0f, 2.0f * glm::length(sum));
  // The horizontal direction in the surface, which faces away from the axis of the head about there.
  const vec2 out = glm::normalize(vec2(q.x, std::max(q.z + 10.0f, 1.0f)));
  return strength * vec3(std::cos(angle) * out.y, std::sin(angle), -std::cos(angle) * out.x);
}

// Vertical furrows, crowded in the middle, fanning out.
float ReliefWalk::lips_mm(const vec3& p, const Region& r) {
  const float up = r.symmetric.y + 68;
  const float wave = lip_wave_({p.x * (1.15f + 0.02f * up), p.y * 0.10f, 0.0f});
  const float fine = lip_fine_({p.x * (2.6f + 0.04f * up), p.y * 0.35f, 3.0f});
  return 0.085f * (std::abs(wave) - 0.3f) + 0.022f * (std::abs(fine) - 0.3f);
}

// Wavy creases, deepest in the middle of the forehead, and finer ones between them.
float ReliefWalk::forehead_mm(const vec3& p, const Region& r) {
  const vec3& q = r.symmetric;
  const float wander = 2.2f * wander_({p.x * 0.03f, p.y * 0.05f, 1});
  const float phase = q.y + wander - 4.0f * std::cos(q.x * 0.035f);
  const float middle = std::exp(-q.x * q.x / 1500);
  const float broken = smooth_step(-0.2f, 0.5f, broken_({p.x * 0.035f, p.y * 0.06f, 7}));
  return -middle * (0.10f * crease(std::sin(phase * 0.30f), 0.20f) * broken +
                    0.022f * crease(std::sin(phase * 1.10f), 0.40f) * (1 - 0.6f * broken));
}

// Fine lines fan from the outer corner and run along the lower lid.
float ReliefWalk::eyes_mm(const vec3& p, const Region& r) {
  const vec3 q(std::abs(r.symmetric.x), r.symmetric.y, r.symmetric.z);
  const float angle = std::atan2(q.y + 2.0f, q.x - 38.0f), reach = std::hypot(q.x - 38.0f, q.y + 2.0f);
  const float fan = std::sin(angle * 9.0f + 0.6f * fan_(p * 0.12f));
  const float lines = std::sin(q.y * 1.5f + 0.05f * q.x * q.x * 0.1f + 1.2f * lower_lid_(p * 0.2f));
  return -0.070f * r.crow * crease(fan, 0.30f) * smooth_step(10, 16, reach) -
         0.040f * r.under_eye * crease(lines, 0.5f);
}

// Rings around the neck, and the fine creases that cross its skin between them.
float ReliefWalk::neck_mm(const vec3& p, const Region& r) {
  const vec3& q = r.symmetric;
  const float ring = std::sin((q.y + 0.22f * q.z + 2.0f * rings_(p * 0.03f)) * 0.16f);
  const float fine = creases_({p.x * 0.10f, (p.y + 0.22f * p.z) * 0.55f, p.z * 0.10f});
  const float front = smooth_step(-10, 20, q.z);
  return -r.neck *
         (0.07f * front * crease(ring, 0.35f) + 0.030f * (0.4f + 0.6f * front) * crease(fine, 0.22f));
}

Relief ReliefWalk::at(const vec3& p, const Region& r) {
  // Pores: wide and deep on nose, inner cheek and chin, hardly any on lids and lips.
  const float bare =
      (1 - r.lips) * (1 - r.scalp) * (1 - 0.85f * std::min(1.0f, r.upper_lid + 0.7f * r.under_eye));
  const float oily =
      std::min(1.0f, r.nose + 0.8f * r.nose_tip + 0.65f * r.cheek + 0.45f * r.forehead + 0.4f * r.chin);
  const vec3 along = drawn_out * r.line;
  Relief relief;

  float h = 0;
  if (bare > 0) {
    const Cell cell = pores_(p * pores_per_mm, along);
    const float size = unit(cell.id * 668265263u), shown = smooth_step(0.0f, 0.2f, 0.35f + oily - size);
    const float radius_mm = 0.17f + 0.10f * oily + 0.08f * unit(cell.id),
                s = cell.nearest / pores_per_mm / radius_mm;
    relief.pore = bare * shown * (0.35f + 0.65f * oily) * falloff(0.8f * s * s);
    h = -0.095f * (0.6f + 0.4f * size) * relief.pore;
  }

  // The net of fine furrows between them, and the softer unevenness of skin.
  const Cell net = furrows_(p * 1.15f, along);
  h -= 0.026f * (1 - r.lips) * (1 - smooth_step(0.02f, 0.22f, net.second - net.nearest));
  h += 0.030f * soft_(p * 0.35f) * (1 - r.lips) + 0.010f * fine_(p * 1.6f);

  if (r.lips > 0) h += r.lips * lips_mm(p, r);
  if (r.forehead > 0.02f) h += r.forehead * forehead_mm(p, r);
  if (std::max(r.crow, 0.8f * r.under_eye) > 0.02f) h += eyes_mm(p, r);
  if (r.neck > 0.05f) h += neck_mm(p, r);
  relief.height_mm = h;
  return relief;
}

}  // namespace dermis::builtin_head
