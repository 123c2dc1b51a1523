// SPDX-License-Identifier: MIT
#include "head/builtin_head/skin.h"

#include "head/builtin_head/landmarks.h"
#include "head/builtin_head/noise.h"

namespace dermis::builtin_head {
namespace {

float bell(const vec3& p, const vec3& centre, const vec3& radii) {
  const vec3 q = (p - centre) / radii;
  return faded(glm::dot(q, q));
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
    : skin_(complexion.skin),
      lips_(complexion.lips),
      hair_colour_(complexion.colours.hair * 1.5f),
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
  r.mottle = layered_noise(p * 0.16f, 3, 5);
  r.blood = layered_noise(p * 0.45f, 2, 13);
  r.oil = layered_noise(p * 0.12f, 2, 71);

  const vec3 e = (ear_.to_local(q) - vec3(1, 1, 2)) / vec3(21.5f, 36, 13);
  r.ear = 1.0f - smooth_step(0.75f, 1.25f, glm::dot(e, e));
  const float face = smooth_step(8, 48, q.z) * smooth_step(-124, -100, q.y);
  r.neck = 1.0f - smooth_step(-128, -108, q.y + 0.35f * (80 - q.z));
  const float nape = smooth_step(-10, -40, q.y) * smooth_step(-10, -40, q.z);  // cut shorter there
  r.scalp =
      smooth_step(-9 - 4 * nape, 22 + 12 * nape, inside_hairline(q) + 4.0f * gradient_noise(p * 0.22f, 3)) *
      (1 - r.ear);
  if (face <= 0) {
    r.line = tension_line(q, r) * vec3(p.x > 0 ? 1 : -1, 1, 1);
    return r;
  }
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
  r.line = tension_line(q, r) * vec3(p.x > 0 ? 1 : -1, 1, 1);
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

// Hair of a few millimetres, from the whorl behind the crown down on all sides: strands as drawn-out cells,
// fewer towards the hairline.
float Skin::crop(const vec3& p, const Region& r, SkinWalk& walk) const {
  if (r.scalp < 0.02f) return 0;
  const vec3 from_whorl = p - vec3(8, 104, -58);
  // Bent, or where the surface lies along its cells they would show as rings.
  const vec3 bent = p + 0.7f * vec3(r.mottle, r.blood, r.oil);
  const vec3 flow = glm::normalize(from_whorl + vec3(0, -0.35f * glm::length(from_whorl), 0));
  float bare = 1;
  for (int layer = 0; layer < 2; ++layer) {
    const Cell c = walk.crop[layer](bent * (layer == 0 ? 1.7f : 2.6f), 0.88f * flow);
    if (unit(c.id) > 1.15f * r.scalp) continue;
    bare *= 1 - (0.45f + 0.25f * r.scalp) * (0.7f + 0.3f * unit(c.id * 2246822519u)) *
                    (1 - smooth_step(0.10f, 0.42f, c.nearest));
  }
  // Roots, and hairs that are finer than a texel.
  return 1 - bare * (1 - 0.56f * r.scalp);
}

vec3 Skin::tint(const vec3& p, const Region& r, float pore, SkinWalk& walk) const {
  const float grain = walk.grain(p * 1.1f);

  // Natural logarithms of how much more melanin and blood there are than on average.
  float melanin =
      0.10f * r.complexion + 0.05f * r.mottle + 0.05f * grain + 0.12f * r.forehead + 0.10f * r.neck - 0.05f;
  float blood = 0.13f * r.mottle + 0.12f * r.blood + 0.10f * r.complexion;
  blood += 0.29f * r.cheek * (1 + 0.25f * r.mottle) + 1.0f * r.nose_tip + 0.75f * r.ear + 0.30f * r.chin +
           0.22f * r.upper_lid - 0.20f * r.forehead - 0.15f;
  const vec3 q(std::abs(r.symmetric.x), r.symmetric.y, r.symmetric.z);
  blood += 0.45f * bell(q, {18, -42, 90}, {5, 8, 10});
  // Sebum in a pore oxidises and is a little darker than the skin around it.
  melanin += 0.45f * pore;

  // Freckles: sparse cells, each with its own size and strength, over cheeks and nose.
  const float where =
      std::min(1.0f, 1.2f * r.cheek + 1.1f * r.nose + 0.25f * r.forehead + 0.12f) * (1 - r.scalp);
  const int layers = where > 0.2f ? 2 : (where > 0.01f ? 1 : 0);
  for (int layer = 0; layer < layers; ++layer) {
    const float scale = layer == 0 ? 0.30f : 0.52f;
    const Cell c = walk.freckles[layer](p * scale + 0.15f * grain);
    const float chance = unit(c.id), radius = (0.10f + 0.16f * unit(c.id * 2246822519u));
    if (chance < 0.55f * where)
      melanin += (0.25f + 0.5f * unit(c.id * 3266489917u)) * where *
                 (1 - smooth_step(0.4f * radius, radius * 1.3f, c.nearest));
  }

  // Blood of the veins below thin skin, and blood that has given off its oxygen, is blue.
  vec3 albedo = skin_.at(melanin, blood + 0.30f * r.under_eye, 0.45f * r.under_eye + 0.15f * r.upper_lid);
  // Its walls keep light from its bottom, as those of the ear's bowl do.
  albedo *= 1 - 0.25f * pore;
  if (r.ear > 0) albedo *= 1 - 0.75f * bell(ear_.to_local(q), {-7.0f, -5.5f, -2.5f}, {3.6f, 4.2f, 5.0f});
  // A shaven beard: hair in the skin looks blue-grey through it.
  const float shaven = 0.60f * r.beard;
  if (shaven > 0.01f) {
    albedo *= glm::mix(vec3(1), vec3(0.84f, 0.87f, 0.91f), shaven);
    const Cell c = walk.stubble(p * 1.25f);
    albedo *= 1.0f - 0.45f * shaven * (1 - smooth_step(0.08f, 0.22f, c.nearest)) * (0.4f + 0.6f * unit(c.id));
  }
  return albedo;
}

SkinPoint Skin::paint(const vec3& p, const Region& r, SkinWalk& walk) const {
  SkinPoint s;
  const vec3 q(std::abs(r.symmetric.x), r.symmetric.y, r.symmetric.z);
  const Relief relief = walk.relief.at(p, r);
  s.height_mm = relief.height_mm;
  s.albedo = tint(p, r, relief.pore, walk);

  // Oil lies on the T-zone in patches; the cheek beside it is drier. A pore hardly mirrors.
  const float oil = r.t_zone * (1 + 0.35f * r.oil);
  const float dry = r.cheek * (1 - r.t_zone);
  s.specular = 0.64f + 0.30f * oil - 0.08f * dry + 0.08f * r.oil - 0.12f * r.neck - 0.08f * r.scalp -
               0.08f * r.under_eye;
  s.specular = std::clamp(s.specular * (1 - 0.45f * relief.pore), 0.0f, 1.0f);
  s.roughness = 0.565f - 0.105f * oil + 0.045f * dry + 0.03f * r.oil + 0.02f * r.neck + 0.04f * relief.pore;

  if (r.lips > 0) {
    // Streaked along the lips' furrows, whose pigments are as uneven as the skin's.
    const float streak = walk.streak(vec3(p.x * 1.5f, p.y * 0.25f, p.z * 0.4f));
    // By the eye it is the lids' edge and the conjunctiva that are bare.
    const vec3 bare =
        q.y > -25 ? 1.25f * lips_.at(0, -0.4f, 0) : lips_.at(-0.15f * streak, -0.25f * streak, 0);
    // The lining of the mouth is redder, and dark where hardly any light comes.
    const float deep = q.y > -25 ? 0.0f : smooth_step(92.0f, 62.0f, q.z);
    const vec3 lip = glm::mix(bare, vec3(0.10f, 0.028f, 0.024f), deep);
    s.albedo = glm::mix(s.albedo, lip, r.lips);
    // Wettest where they meet; what lies deeper is hardly lit, so that it must not mirror, nor the lids' edge
    // as much as the lips.
    const vec2 line = mouth_.nearest(q, 6.0f);
    const float wet = 1 - smooth_step(1.5f, 5.0f, line.x), folded = 1 - smooth_step(0.4f, 1.4f, line.x);
    const bool lid = q.y > -25;
    const float gloss = lid ? 0.6f : (1 - 0.75f * std::max(folded, deep));
    s.specular = glm::mix(s.specular, gloss, r.lips);
    s.roughness = glm::mix(s.roughness, lid ? 0.50f : 0.465f - 0.040f * wet, r.lips);
    s.albedo *= 1.0f - 0.15f * (1 - smooth_step(0.2f, 0.8f, line.x));
  }

  const float cropped = crop(p, r, walk);
  s.height_mm += 0.10f * cropped;
  s.specular += (0.21f - s.specular) * cropped;
  s.roughness += (0.68f - s.roughness) * cropped;
  const float brows = hair(p, q), hairs = std::max(brows, cropped);
  s.albedo = glm::mix(s.albedo, hair_colour_, 0.94f * hairs);
  s.specular *= 1.0f - 0.5f * brows;
  s.albedo = glm::clamp(s.albedo, vec3(0.01f), vec3(0.95f));
  return s;
}

}  // namespace dermis::builtin_head
