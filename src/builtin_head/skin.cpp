// SPDX-License-Identifier: MIT
#include "builtin_head/skin.h"

#include "builtin_head/landmarks.h"
#include "builtin_head/noise.h"

namespace dermis::builtin_head {
namespace {

float bell(const vec3& p, const vec3& centre, const vec3& radii) {
  const vec3 q = (p - centre) / radii;
  return std::exp(-glm::dot(q, q));
}

// Returns y of a curve at x (its points run outwards).
float height_at(const std::vector<vec3>& curve, float x) {
  std::size_t i = 0;
  while (i + 2 < curve.size() && curve[i + 1].x < x) ++i;
  const float t = std::clamp((x - curve[i].x) / std::max(curve[i + 1].x - curve[i].x, 1e-4f), 0.0f, 1.0f);
  return glm::mix(curve[i].y, curve[i + 1].y, t);
}

// The hairline before the ear: z over y (as x and y of the points).
const std::vector<vec3> temple_line = {{-26, 10, 0}, {-12, 20, 0}, {8, 27, 0},
                                       {24, 36, 0},  {40, 46, 0},  {58, 54, 0}};

// Returns how far a point lies within the hairline, about mm: across the forehead with a bay over each
// temple, down before the ear, behind it, and across the nape.
float inside_hairline(const vec3& q) {
  const float bay = (q.x - 31.0f) / 15.0f;
  const float front = 0.8f * (q.y - 71.0f - 7.0f * std::exp(-bay * bay));
  const float temple = height_at(temple_line, std::clamp(q.y, -26.0f, 58.0f)) - q.z;
  const float above = q.y > -10 ? std::max(front, temple) : std::min(temple, q.y + 24.0f);
  const float behind = std::min(-24.0f - q.z, q.y + 74.0f + 0.08f * q.x);
  return std::max(above, behind);
}

}  // namespace

Skin::Skin(const Sculpture& bust, const Complexion& complexion)
    : complexion_(complexion),
      table_(skin_table()),
      ear_(bust.ear_frame()),
      lash_(upper_lid, {1, 0, 0, 0, true}, 4),
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
  r.symmetric = {p.x > 0 ? q.x : -q.x, q.y, q.z};
  r.complexion = layered_noise(p * 0.030f, 3, 1);

  const vec3 e = (ear_.to_local(q) - vec3(1, 1, 2)) / vec3(21.5f, 36, 13);
  r.ear = 1.0f - smooth_step(0.75f, 1.25f, glm::dot(e, e));
  const float face = smooth_step(8, 48, q.z) * smooth_step(-124, -100, q.y);
  r.neck = 1.0f - smooth_step(-128, -108, q.y + 0.35f * (80 - q.z));
  r.scalp = smooth_step(-7, 12, inside_hairline(q) + 4.0f * gradient_noise(p * 0.22f, 3)) * (1 - r.ear);
  if (face <= 0) return r;
  r.lips = lip_mask(q);
  r.cheek = face * (bell(q, {38, -27, 78}, {22, 19, 34}) + 0.5f * bell(q, {52, -42, 58}, {20, 26, 34}));
  r.nose_tip = bell(q, {0, -38, 116}, {13, 9, 14}) + 0.8f * bell(q, {15, -43, 96}, {5, 6, 8});
  r.nose = bell(q, {0, -24, 104}, {15, 26, 24});
  r.forehead = face * smooth_step(14, 34, q.y) * (1 - r.scalp);
  r.t_zone = std::min(1.0f, r.nose + r.nose_tip + r.forehead * std::exp(-q.x * q.x / 900) +
                                0.6f * bell(q, {0, -100, 94}, {18, 12, 16}));
  r.under_eye = bell(q, {28, -15, 78}, {14, 7, 16});
  r.upper_lid = bell(q, {31, 1, 80}, {17, 9, 16});
  r.crow = bell(q, {55, -3, 60}, {9, 13, 16});
  r.chin = face * bell(q, {0, -102, 94}, {24, 15, 24});
  const float moustache = bell(q, {12, -55, 97}, {16, 7, 14});
  const float jaw = smooth_step(-52, -76, q.y + 0.25f * (60 - q.z)) * (1 - smooth_step(-112, -140, q.y)) *
                    smooth_step(2, 22, q.z);
  r.beard = std::min(1.0f, std::max(jaw, moustache)) * (1 - r.lips);
  return r;
}

Region blend(const Region& a, const Region& b, float t) {
  constexpr float Region::*parts[] = {
      &Region::lips,     &Region::cheek,  &Region::nose_tip,  &Region::nose,      &Region::ear,
      &Region::forehead, &Region::t_zone, &Region::under_eye, &Region::upper_lid, &Region::beard,
      &Region::scalp,    &Region::neck,   &Region::crow,      &Region::chin,      &Region::complexion};
  Region r;
  r.symmetric = glm::mix(a.symmetric, b.symmetric, t);
  for (float Region::*const part : parts) r.*part = a.*part + t * (b.*part - a.*part);
  return r;
}

float Skin::hair(const vec3& p, const vec3& q) const {
  if (q.z < 45 || q.y < -20 || q.y > 34 || q.x > 64) return 0;
  // The hairs themselves are cards; a softer layer of them lies on the skin.
  float cover = 0.35f * hairs_.coverage({p.x > 0 ? q.x : -q.x, q.y}, 0.35f);
  // The skin under the brow is darker for the roots in it, and the lids' edge for the roots of the lashes.
  const vec2 brow = brow_.nearest(q, 6.0f);
  if (brow.x < 6.0f) {
    const float half = 4.4f * (1 - 0.7f * brow.y);
    cover = std::max(cover, 0.22f * (1 - smooth_step(0.3f * half, 1.1f * half, brow.x)) *
                                smooth_step(0.0f, 0.12f, brow.y) * (1 - smooth_step(0.85f, 1.0f, brow.y)));
  }
  const vec2 lash = lash_.nearest(q, 1.2f);
  return std::max(cover, 0.80f * (1 - smooth_step(0.15f, 0.75f, lash.x)) * smooth_step(0.02f, 0.12f, lash.y) *
                             (1 - smooth_step(0.97f, 1.0f, lash.y)));
}

vec3 Skin::tint(const vec3& p, const Region& r) const {
  const float broad = r.complexion, mottle = layered_noise(p * 0.16f, 3, 5),
              grain = gradient_noise(p * 1.1f, 9);

  // Natural logarithms of how much more melanin and blood there are than on average.
  float melanin =
      0.10f * broad + 0.05f * mottle + 0.05f * grain + 0.12f * r.forehead + 0.10f * r.neck - 0.05f;
  float blood = 0.20f * mottle + 0.14f * layered_noise(p * 0.45f, 2, 13) + 0.10f * broad;
  blood += 0.45f * r.cheek * (1 + 0.7f * mottle) + 1.25f * r.nose_tip + 0.75f * r.ear + 0.30f * r.chin +
           0.40f * r.upper_lid - 0.20f * r.forehead - 0.15f;
  const vec3 q(std::abs(r.symmetric.x), r.symmetric.y, r.symmetric.z);
  blood += 0.45f * bell(q, {18, -42, 90}, {5, 8, 10});

  // Freckles: sparse cells, each with its own size and strength, over cheeks and nose.
  const float where = std::min(1.0f, 1.2f * r.cheek + 1.1f * r.nose + 0.25f * r.forehead + 0.12f);
  for (int layer = 0; layer < (where > 0.2f ? 2 : 1); ++layer) {
    const float scale = layer == 0 ? 0.30f : 0.52f;
    const Cell c = cells(p * scale + 0.15f * grain, 41u + static_cast<std::uint32_t>(layer));
    const float chance = unit(c.id), radius = (0.10f + 0.16f * unit(c.id * 2246822519u));
    if (chance < 0.55f * where)
      melanin += (0.25f + 0.5f * unit(c.id * 3266489917u)) * where *
                 (1 - smooth_step(0.4f * radius, radius * 1.3f, c.nearest));
  }

  // Blood of the veins below thin skin, and blood that has given off its oxygen, is blue.
  const optics::Pigments& mean = complexion_.skin;
  const std::array<float, 3> colour = table_.at(
      optics::Pigments{.melanin = mean.melanin * double{std::exp(melanin)},
                       .haemoglobin = mean.haemoglobin * double{std::exp(blood + 0.30f * r.under_eye)},
                       .oxygenation = mean.oxygenation - double{0.45f * r.under_eye + 0.15f * r.upper_lid}});
  vec3 albedo(colour[0], colour[1], colour[2]);
  // A shaven beard and a shaven scalp: hair in the skin looks blue-grey through it.
  const float shaven = std::max(0.60f * r.beard, 0.95f * r.scalp);
  if (shaven > 0.01f) {
    albedo *= glm::mix(vec3(1), vec3(0.84f, 0.87f, 0.91f), shaven);
    albedo *= glm::mix(vec3(1), vec3(0.62f, 0.66f, 0.70f), r.scalp);
    const Cell c = cells(p * 1.25f, 61);
    albedo *= 1.0f - 0.38f * shaven * (1 - smooth_step(0.08f, 0.22f, c.nearest)) * (0.4f + 0.6f * unit(c.id));
  }
  return albedo;
}

// Streaked along the lips' furrows, whose pigments are as uneven as the skin's.
vec3 Skin::lip_colour(const vec3& p) const {
  const float streak = gradient_noise(vec3(p.x * 1.5f, p.y * 0.25f, p.z * 0.4f), 81);
  const std::array<float, 3> colour = table_.at(
      optics::Pigments{.melanin = complexion_.lips.melanin * double{std::exp(-0.15f * streak)},
                       .haemoglobin = complexion_.lips.haemoglobin * double{std::exp(-0.25f * streak)},
                       .oxygenation = complexion_.lips.oxygenation});
  return {colour[0], colour[1], colour[2]};
}

SkinPoint Skin::paint(const vec3& p, const Region& r) const {
  SkinPoint s;
  const vec3 q(std::abs(r.symmetric.x), r.symmetric.y, r.symmetric.z);
  s.albedo = tint(p, r);

  const float patch = layered_noise(p * 0.12f, 2, 71);
  s.specular = std::clamp(
      0.62f + 0.30f * r.t_zone + 0.08f * patch - 0.12f * r.neck - 0.08f * r.scalp - 0.08f * r.under_eye, 0.0f,
      1.0f);
  s.roughness = 0.565f - 0.085f * r.t_zone + 0.03f * patch + 0.02f * r.cheek + 0.02f * r.neck;

  if (r.lips > 0) {
    // By the eye it is the lids' edge and the conjunctiva that are bare.
    const vec3 bare = q.y > -25 ? vec3(0.48f, 0.30f, 0.25f) : lip_colour(p);
    // The lining of the mouth is redder, and dark where hardly any light comes.
    const float deep = q.y > -25 ? 0.0f : smooth_step(92.0f, 62.0f, q.z);
    const vec3 lip = glm::mix(bare, vec3(0.10f, 0.028f, 0.024f), deep);
    s.albedo = glm::mix(s.albedo, lip, r.lips);
    s.specular = glm::mix(s.specular, 1.0f, r.lips);
    s.roughness = glm::mix(s.roughness, 0.46f, r.lips);
    const vec2 line = mouth_.nearest(q, 2.5f);
    s.albedo *= 1.0f - 0.15f * (1 - smooth_step(0.2f, 0.8f, line.x));
  }

  const float hairs = hair(p, q);
  s.albedo = glm::mix(s.albedo, vec3(0.055f, 0.036f, 0.026f), 0.94f * hairs);
  s.specular *= 1.0f - 0.5f * hairs;
  s.albedo = glm::clamp(s.albedo, vec3(0.01f), vec3(0.95f));
  return s;
}

float Skin::relief_mm(const vec3& p, const Region& r) const {
  const vec3 q(std::abs(r.symmetric.x), r.symmetric.y, r.symmetric.z);
  // Pores: wide and deep on nose, inner cheek and chin, hardly any on lids and lips.
  const float bare = (1 - r.lips) * (1 - 0.85f * std::min(1.0f, r.upper_lid + 0.7f * r.under_eye));
  const float oily =
      std::min(1.0f, r.nose + 0.8f * r.nose_tip + 0.55f * r.cheek + 0.45f * r.forehead + 0.4f * r.chin);
  const Cell pore = cells(p * 0.78f, 101);
  const float radius = 0.16f + 0.10f * unit(pore.id);
  float h = -bare * (0.024f + 0.062f * oily) * (0.4f + 0.6f * unit(pore.id * 668265263u)) *
            (1 - smooth_step(0.3f * radius, 1.5f * radius, pore.nearest));

  // The net of fine furrows between them, and the softer unevenness of skin.
  const Cell net = cells(p * 1.15f + 0.35f * gradient_noise(p * 0.6f, 107), 103);
  h -= 0.016f * (1 - r.lips) * (1 - smooth_step(0.02f, 0.22f, net.second - net.nearest));
  h += 0.030f * gradient_noise(p * 0.35f, 109) * (1 - r.lips) + 0.010f * gradient_noise(p * 1.6f, 113);

  if (r.lips > 0) {
    // Vertical furrows, crowded in the middle, fanning out.
    const float wave = gradient_noise(vec3(p.x * 1.15f + 0.02f * p.x * (q.y + 68), p.y * 0.10f, 0.0f), 127);
    const float fine = gradient_noise(vec3(p.x * 2.6f, p.y * 0.35f, 3.0f), 131);
    h += r.lips * (0.075f * (std::abs(wave) - 0.3f) * 1.3f + 0.02f * fine);
  }

  if (r.forehead > 0.02f) {
    // Draws wavy creases, deepest in the middle of the forehead.
    const float wander = 2.2f * gradient_noise(vec3(p.x * 0.03f, p.y * 0.05f, 1), 137);
    const float crease = std::abs(std::sin((q.y + wander - 4.0f * std::cos(q.x * 0.035f)) * 0.30f));
    h -= 0.085f * r.forehead * (1 - smooth_step(0.0f, 0.20f, crease)) *
         smooth_step(-0.2f, 0.5f, gradient_noise(vec3(p.x * 0.035f, p.y * 0.06f, 7), 139)) *
         std::exp(-q.x * q.x / 1500);
  }

  const float eye = std::max(r.crow, 0.8f * r.under_eye);
  if (eye > 0.02f) {
    // Fine lines fan from the outer corner and run along the lower lid.
    const float angle = std::atan2(q.y + 2.0f, q.x - 38.0f), reach = std::hypot(q.x - 38.0f, q.y + 2.0f);
    const float fan = std::abs(std::sin(angle * 9.0f + 0.6f * gradient_noise(p * 0.12f, 149)));
    h -= 0.060f * r.crow * (1 - smooth_step(0.0f, 0.30f, fan)) * smooth_step(10, 16, reach);
    h -= 0.030f * r.under_eye *
         (1 - smooth_step(0.0f, 0.5f,
                          std::abs(std::sin(q.y * 1.5f + 0.05f * q.x * q.x * 0.1f +
                                            1.2f * gradient_noise(p * 0.2f, 151)))));
  }

  if (r.neck > 0.05f) {
    const float ring =
        std::abs(std::sin((q.y + 0.22f * q.z + 2.0f * gradient_noise(p * 0.03f, 157)) * 0.16f));
    h -= 0.13f * r.neck * (1 - smooth_step(0.0f, 0.22f, ring)) * smooth_step(-10, 20, q.z);
  }
  return h;
}

}  // namespace dermis::builtin_head
