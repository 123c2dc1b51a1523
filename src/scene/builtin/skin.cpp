// SPDX-License-Identifier: MIT
#include "scene/builtin/skin.h"

#include "scene/builtin/landmarks.h"
#include "scene/builtin/noise.h"

namespace dermis::scene::builtin {
namespace {

// Optical densities of one unit more of melanin and of blood (red, green, blue): melanin falls steadily from blue to red, haemoglobin
// takes green and blue and hardly any red.
const vec3 melanin_density(0.22f, 0.40f, 0.62f);
const vec3 blood_density(0.06f, 0.62f, 0.46f);
const vec3 base_albedo(0.60f, 0.385f, 0.275f);  // a light to medium complexion, linear

float bell(const vec3& p, const vec3& centre, const vec3& radii) {
  const vec3 q = (p - centre) / radii;
  return std::exp(-glm::dot(q, q));
}

// y of a curve over x (its points run outwards).
float height_at(const std::vector<vec3>& curve, float x) {
  std::size_t i = 0;
  while (i + 2 < curve.size() && curve[i + 1].x < x) ++i;
  const float t = std::clamp((x - curve[i].x) / std::max(curve[i + 1].x - curve[i].x, 1e-4f), 0.0f, 1.0f);
  return glm::mix(curve[i].y, curve[i + 1].y, t);
}

// One layer of short hairs laid along a direction: `along` and `across` in mm; returns coverage 0..1.
float hair_layer(float along, float across, float length_mm, float pitch_mm, float width_mm, std::uint32_t seed) {
  const float row = std::floor(across / pitch_mm);
  float cover = 0;
  for (int k = -1; k <= 1; ++k) {
    const int lane = static_cast<int>(row) + k;
    const std::uint32_t h = lattice_hash(lane, 17, 0, seed);
    const float shifted = along + unit(h) * length_mm;
    const int cell = static_cast<int>(std::floor(shifted / length_mm));
    const std::uint32_t g = lattice_hash(lane, cell, 5, seed);
    const float t = shifted / length_mm - static_cast<float>(cell);                         // 0 at the root
    const float bend = (unit(g) - 0.5f) * 0.9f * t + 0.3f * (unit(g * 747796405u) - 0.5f);  // in pitches
    const float middle = (static_cast<float>(lane) + 0.5f + bend) * pitch_mm;
    const float width = width_mm * (1.0f - 0.75f * t) * smooth_step(0, 0.06f, t) * (0.7f + 0.6f * unit(g ^ 0x5bd1e995u));
    cover = std::max(cover, 1.0f - smooth_step(0.35f * width, width + 0.06f, std::abs(across - middle)));
  }
  return cover;
}

}  // namespace

Skin::Skin(const Sculpture& bust)
    : ear_(bust.ear_frame()),
      lash_(lash_line, {1, 0, 0, 0, true}, 4),
      brow_(brow_line, {1, 0, 0, 0, true}, 4),
      mouth_(mouth_line, {1, 0, 0, 0, true}, 4),
      upper_lip_(smooth_curve(upper_border, 4)),
      lower_lip_(smooth_curve(lower_border, 4)) {}

float Skin::lip_mask(const vec3& q) const {
  if (q.z < 65 || q.x > 29 || q.y > -56 || q.y < -84) return 0;
  const float inside = std::min(height_at(upper_lip_, q.x) - q.y, q.y - height_at(lower_lip_, q.x) + 0.4f);
  return smooth_step(-0.9f, 0.8f, inside) * (1.0f - smooth_step(24.0f, 27.5f, q.x));
}

Region Skin::region(const vec3& p) const {
  Region r;
  vec3 q = to_symmetric(p);
  q.x = std::abs(q.x);
  r.symmetric = q;
  const vec3 e = (q - ear_.origin) / vec3(17, 36, 26);
  r.ear = 1.0f - smooth_step(0.7f, 1.15f, glm::dot(e, e));
  const float face = smooth_step(8, 48, q.z) * smooth_step(-124, -100, q.y);
  r.neck = 1.0f - smooth_step(-128, -108, q.y + 0.35f * (80 - q.z));
  r.scalp = std::max(smooth_step(58, 84, q.y - 0.30f * (q.z - 60)) * smooth_step(-30, 20, q.y),
                     smooth_step(12, -14, q.z) * smooth_step(-58, -36, q.y + 0.25f * q.z) * (1 - r.ear)) *
            (1 - r.ear);
  if (face <= 0) return r;
  r.lips = lip_mask(q);
  r.cheek = face * (bell(q, {41, -27, 76}, {21, 17, 30}) + 0.5f * bell(q, {52, -40, 60}, {16, 20, 26}));
  r.nose_tip = bell(q, {0, -38, 116}, {13, 9, 14}) + 0.8f * bell(q, {15, -43, 96}, {5, 6, 8});
  r.nose = bell(q, {0, -24, 104}, {15, 26, 24});
  r.forehead = face * smooth_step(14, 34, q.y) * (1 - r.scalp);
  r.t_zone = std::min(1.0f, r.nose + r.nose_tip + r.forehead * std::exp(-q.x * q.x / 900) + 0.6f * bell(q, {0, -100, 94}, {18, 12, 16}));
  r.under_eye = bell(q, {28, -15, 78}, {14, 7, 16});
  r.upper_lid = bell(q, {31, 1, 80}, {17, 9, 16});
  r.crow = bell(q, {55, -3, 60}, {9, 13, 16});
  r.chin = face * bell(q, {0, -102, 94}, {24, 15, 24});
  const float moustache = bell(q, {12, -55, 97}, {16, 7, 14});
  const float jaw = smooth_step(-52, -76, q.y + 0.25f * (60 - q.z)) * (1 - smooth_step(-112, -140, q.y)) * smooth_step(2, 22, q.z);
  r.beard = std::min(1.0f, std::max(jaw, moustache)) * (1 - r.lips);
  return r;
}

float Skin::brow_hair(const vec3& p, const vec3& q) const {
  const vec2 n = brow_.nearest(q, 7);
  if (n.x > 6.5f || q.z < 50) return 0;
  const float middle = height_at(brow_line, q.x), across = q.y - middle;
  const float half = 4.6f * std::pow(1.0f - n.y, 0.45f) * smooth_step(-0.10f, 0.16f, n.y) + 0.8f;
  const float density =
      (1.0f - smooth_step(0.45f * half, half, std::abs(across))) * smooth_step(0.0f, 0.10f, n.y) * (1 - smooth_step(0.88f, 1.0f, n.y));
  if (density <= 0) return 0;
  // Upright at the nose, lying outwards along the arch; upper hairs lean down, lower ones up.
  const float lean = glm::mix(1.15f, 0.15f, smooth_step(0.0f, 0.45f, n.y)) - 0.10f * across * smooth_step(0.2f, 0.6f, n.y);
  const float c = std::cos(lean), s = std::sin(lean);
  const float x = q.x, y = q.y - 0.55f * (middle - 20.0f);
  const std::uint32_t side = p.x > 0 ? 1u : 0u;
  const float a = hair_layer(c * x + s * y, -s * x + c * y, 6.0f, 0.62f, 0.17f, 11 + side);
  const float b = hair_layer(c * x + s * y + 2, -s * x + c * y, 7.5f, 0.74f, 0.17f, 23 + side);
  const float thin = smooth_step(0.05f, 0.5f, density + 0.35f * gradient_noise(p * 0.7f, 31));
  return std::min(1.0f, 0.30f * density + 0.62f * std::max(a, b) * thin);
}

float Skin::lashes(const vec3& p, const vec3& q) const {
  const vec2 n = lash_.nearest(q, 5.0f);
  if (n.x > 4.9f || q.z < 55) return 0;
  const float ends = smooth_step(0.02f, 0.12f, n.y) * (1 - smooth_step(0.97f, 1.0f, n.y));
  const float line = (1 - smooth_step(0.25f, 0.75f, n.x)) * ends;
  const float below = height_at(lash_line, q.x) - q.y;
  float hair = 0;
  if (below > 0 && below < 4.4f) {
    // Lashes of the upper lid lie over the lower one and fan out.
    const float fan = (q.x - 29.0f) * 0.045f;
    const float lane = (q.x - fan * below) / 0.85f;
    const int k = static_cast<int>(std::floor(lane));
    const std::uint32_t h = lattice_hash(k, p.x > 0 ? 1 : 0, 3, 77);
    const float length = (2.0f + 1.9f * unit(h)) * (0.6f + 0.5f * n.y);
    const float at = 0.5f + 0.5f * (unit(h * 2654435761u) - 0.5f);
    const float width = 0.16f * std::max(1 - below / length, 0.0f);
    hair = below < length ? 1 - smooth_step(0.3f * width, width + 0.10f, std::abs(lane - static_cast<float>(k) - at) * 0.85f) : 0.0f;
  }
  return std::min(1.0f, 0.85f * line + 0.55f * hair * ends);
}

vec3 Skin::tint(const vec3& p, const Region& r) const {
  const float broad = layered_noise(p * 0.030f, 3, 1), mottle = layered_noise(p * 0.16f, 3, 5), grain = gradient_noise(p * 1.1f, 9);
  float melanin = 0.10f * broad + 0.05f * mottle + 0.05f * grain + 0.16f * r.forehead + 0.10f * r.neck - 0.10f * r.lips;
  float blood = 0.10f * mottle + 0.07f * layered_noise(p * 0.45f, 2, 13) + 0.05f * broad;
  blood += 0.55f * r.cheek * (1 + 0.5f * mottle) + 0.55f * r.nose_tip + 0.60f * r.ear + 0.18f * r.chin + 0.20f * r.upper_lid -
           0.10f * r.forehead;
  blood += 0.25f * bell(r.symmetric, {18, -42, 90}, {5, 8, 10});
  // Freckles: sparse cells, each with its own size and strength, over cheeks and nose.
  const float where = std::min(1.0f, 1.2f * r.cheek + 1.1f * r.nose + 0.25f * r.forehead + 0.12f);
  for (int layer = 0; layer < 2; ++layer) {
    const float scale = layer == 0 ? 0.30f : 0.52f;
    const Cell c = cells(p * scale + 0.15f * grain, 41u + static_cast<std::uint32_t>(layer));
    const float chance = unit(c.id), radius = (0.10f + 0.16f * unit(c.id * 2246822519u));
    if (chance < 0.55f * where)
      melanin += (0.25f + 0.5f * unit(c.id * 3266489917u)) * where * (1 - smooth_step(0.4f * radius, radius * 1.3f, c.nearest));
  }
  vec3 albedo = base_albedo * glm::exp(-melanin * melanin_density - blood * blood_density);
  // Thin skin over veins; a shaven beard and a shaven scalp: hair in the skin looks blue-grey through it.
  albedo *= glm::mix(vec3(1), vec3(0.88f, 0.86f, 0.92f), r.under_eye * 0.8f);
  albedo *= glm::mix(vec3(1), vec3(0.93f, 0.90f, 0.92f), r.upper_lid * 0.7f);
  const float shaven = std::max(0.60f * r.beard, 0.95f * r.scalp);
  if (shaven > 0.01f) {
    albedo *= glm::mix(vec3(1), vec3(0.84f, 0.87f, 0.91f), shaven);
    const Cell c = cells(p * 1.25f, 61);
    albedo *= 1.0f - 0.38f * shaven * (1 - smooth_step(0.08f, 0.22f, c.nearest)) * (0.4f + 0.6f * unit(c.id));
  }
  return albedo;
}

SkinPoint Skin::paint(const vec3& p, const Region& r) const {
  SkinPoint s;
  const vec3& q = r.symmetric;
  s.albedo = tint(p, r);
  const float patch = layered_noise(p * 0.12f, 2, 71);
  s.specular = std::clamp(0.62f + 0.30f * r.t_zone + 0.08f * patch - 0.12f * r.neck - 0.08f * r.scalp - 0.08f * r.under_eye, 0.0f, 1.0f);
  s.roughness = 0.565f - 0.085f * r.t_zone + 0.03f * patch + 0.02f * r.cheek + 0.02f * r.neck;
  if (r.lips > 0) {
    const float streak = gradient_noise(vec3(p.x * 1.5f, p.y * 0.25f, p.z * 0.4f), 81);
    const vec3 lip = vec3(0.455f, 0.205f, 0.175f) * (1.0f + 0.10f * streak);
    s.albedo = glm::mix(s.albedo, lip, 0.80f * r.lips);
    s.specular = glm::mix(s.specular, 1.0f, r.lips);
    s.roughness = glm::mix(s.roughness, 0.46f, r.lips);
    const vec2 line = mouth_.nearest(q, 2.5f);
    s.albedo *= 1.0f - 0.45f * (1 - smooth_step(0.2f, 1.5f, line.x));
  }
  const float hair = std::max(brow_hair(p, q), lashes(p, q));
  s.albedo = glm::mix(s.albedo, vec3(0.055f, 0.036f, 0.026f), 0.92f * hair);
  s.specular *= 1.0f - 0.5f * hair;
  s.albedo = glm::clamp(s.albedo, vec3(0.01f), vec3(0.95f));
  return s;
}

float Skin::relief_mm(const vec3& p, const Region& r) const {
  const vec3& q = r.symmetric;
  // Pores: wide and deep on nose, inner cheek and chin, hardly any on lids and lips.
  const float bare = (1 - r.lips) * (1 - 0.85f * std::min(1.0f, r.upper_lid + 0.7f * r.under_eye));
  const float oily = std::min(1.0f, r.nose + 0.8f * r.nose_tip + 0.55f * r.cheek + 0.45f * r.forehead + 0.4f * r.chin);
  const Cell pore = cells(p * 0.78f, 101);
  const float radius = 0.16f + 0.10f * unit(pore.id);
  float h = -bare * (0.018f + 0.040f * oily) * (0.4f + 0.6f * unit(pore.id * 668265263u)) *
            (1 - smooth_step(0.3f * radius, 1.5f * radius, pore.nearest));
  // The net of fine furrows between them, and the softer unevenness of skin.
  const Cell net = cells(p * 1.15f + 0.35f * gradient_noise(p * 0.6f, 107), 103);
  h -= 0.012f * (1 - r.lips) * (1 - smooth_step(0.02f, 0.22f, net.second - net.nearest));
  h += 0.030f * gradient_noise(p * 0.35f, 109) * (1 - r.lips) + 0.010f * gradient_noise(p * 1.6f, 113);
  if (r.lips > 0) {
    // Vertical furrows, crowded in the middle, fanning out.
    const float wave = gradient_noise(vec3(p.x * 1.15f + 0.02f * p.x * (q.y + 68), p.y * 0.10f, 0.0f), 127);
    const float fine = gradient_noise(vec3(p.x * 2.6f, p.y * 0.35f, 3.0f), 131);
    h += r.lips * (0.075f * (std::abs(wave) - 0.3f) * 1.3f + 0.02f * fine);
  }
  if (r.forehead > 0.02f) {
    const float wander = 2.2f * gradient_noise(vec3(p.x * 0.03f, p.y * 0.05f, 1), 137);
    const float crease = std::abs(std::sin((q.y + wander - 4.0f * std::cos(q.x * 0.035f)) * 0.30f));
    h -= 0.085f * r.forehead * (1 - smooth_step(0.0f, 0.20f, crease)) *
         smooth_step(-0.2f, 0.5f, gradient_noise(vec3(p.x * 0.035f, p.y * 0.06f, 7), 139)) * std::exp(-q.x * q.x / 1500);
  }
  const float eye = std::max(r.crow, 0.8f * r.under_eye);
  if (eye > 0.02f) {
    // Fine lines fan from the outer corner and run along the lower lid.
    const float angle = std::atan2(q.y + 2.0f, q.x - 38.0f), reach = std::hypot(q.x - 38.0f, q.y + 2.0f);
    const float fan = std::abs(std::sin(angle * 9.0f + 0.6f * gradient_noise(p * 0.12f, 149)));
    h -= 0.060f * r.crow * (1 - smooth_step(0.0f, 0.30f, fan)) * smooth_step(10, 16, reach);
    h -= 0.030f * r.under_eye *
         (1 - smooth_step(0.0f, 0.5f, std::abs(std::sin(q.y * 1.5f + 0.05f * q.x * q.x * 0.1f + 1.2f * gradient_noise(p * 0.2f, 151)))));
  }
  if (r.neck > 0.05f) {
    const float ring = std::abs(std::sin((q.y + 0.22f * q.z + 2.0f * gradient_noise(p * 0.03f, 157)) * 0.16f));
    h -= 0.10f * r.neck * (1 - smooth_step(0.0f, 0.10f, ring)) * smooth_step(-10, 20, q.z);
  }
  return h;
}

}  // namespace dermis::scene::builtin
