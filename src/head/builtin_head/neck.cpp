// SPDX-License-Identifier: MIT
#include <array>

#include "head/builtin_head/sculpture.h"

namespace dermis::builtin_head {
namespace {

struct Section {
  float y, half_width, half_depth, middle_z;
};
// From the base of the skull down to the chest; the neck leans forwards going up.
constexpr std::array<Section, 8> sections = {{{-20, 57, 47, -26},
                                              {-50, 56.5f, 47, -25},
                                              {-80, 56, 49.5f, -24},
                                              {-110, 56, 52, -23.5f},
                                              {-138, 57, 54.5f, -28},
                                              {-158, 59, 56.5f, -34},
                                              {-185, 64, 58, -42},
                                              {-225, 76, 62, -50}}};

Section section_at(float y) {
  std::size_t i = 0;
  while (i + 2 < sections.size() && y < sections[i + 1].y) ++i;
  const Section &a = sections[i > 0 ? i - 1 : 0], &b = sections[i], &c = sections[i + 1],
                &d = sections[std::min(i + 2, sections.size() - 1)];
  const float t = std::clamp((y - b.y) / (c.y - b.y), 0.0f, 1.0f), span = c.y - b.y;
  // Cubic Hermite with slopes over the true spacing.
  const auto blend = [&](float Section::*m) {
    const float mb = &a == &b ? (c.*m - b.*m) / span : (c.*m - a.*m) / (c.y - a.y);
    const float mc = &d == &c ? (c.*m - b.*m) / span : (d.*m - b.*m) / (d.y - b.y);
    const float t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * (b.*m) + (t3 - 2 * t2 + t) * span * mb + (3 * t2 - 2 * t3) * (c.*m) +
           (t3 - t2) * span * mc;
  };
  return {y, blend(&Section::half_width), blend(&Section::half_depth), blend(&Section::middle_z)};
}

}  // namespace

Neck::Neck()
    : shoulder_({{{0, -172, -66}, 41},
                 {{34, -186, -62}, 42},
                 {{72, -207, -54}, 42},
                 {{112, -228, -48}, 42},
                 {{150, -246, -46}, 42}}),
      clavicle_({{{11, -198, 10}, 5.5f},
                 {{30, -195, 8}, 5.5f},
                 {{56, -190, -2}, 5.0f},
                 {{84, -186, -16}, 5.5f},
                 {{112, -190, -30}, 6.0f}}) {
  // sternocleidomastoid: from behind the ear to the pit of the neck, and the hollow before it
  strokes_.emplace_back(std::vector<vec3>{{62, -46, -24},
                                          {60, -72, -18},
                                          {55, -98, -8},
                                          {46, -125, 2},
                                          {33, -152, 10},
                                          {18, -180, 14},
                                          {12, -198, 14}},
                        Stroke::Brush{15, 3.2f, 0.15f, 0, false});
  strokes_.emplace_back(std::vector<vec3>{{52, -92, 10}, {44, -112, 14}, {32, -136, 20}, {19, -164, 18}},
                        Stroke::Brush{13, -1.8f, 0.3f, 0.4f, false});

  dabs_ = {
      {{0, -148, 29}, {12, 24, 16}, 2.2f},     // larynx
      {{0, -130, 32}, {20, 9, 16}, -1.2f},     // above it
      {{0, -189, 15}, {14, 14, 16}, -1.6f},    // pit of the neck
      {{58, -174, -14}, {24, 16, 24}, -4.0f},  // hollow over the clavicle
      {{0, -96, -74}, {13, 40, 16}, -1.6f},    // nape
  };
}

float Neck::mass(const vec3& p) const {
  const Section s = section_at(p.y);
  const vec2 q(p.x, p.z - s.middle_z), r(s.half_width, s.half_depth);
  const float k0 = glm::length(q / r), k1 = glm::length(q / (r * r));
  const float round = k1 > 1e-6f ? k0 * (k0 - 1) / k1 : -std::min(r.x, r.y);
  // Ends inside the skull.
  float f = soft_max(0.95f * round, p.y + 30.0f, 20.0f);
  if (p.y > -80.0f) return f;

  // Trapezius and shoulder, the upper ribs, and the collar bone on them.
  f = soft_min(f, shoulder_(p, f + 48.0f), 48.0f);
  f = soft_min(f, ellipsoid(p - vec3(0, -262, -42), {150, 74, 62}), 26.0f);
  return soft_min(f, clavicle_(p, f + 9.0f), 9.0f);
}

float Neck::add_muscles(float f, const vec3& p) const {
  if (p.y > -30) return f;
  for (const Stroke& s : strokes_) f -= s(p);
  for (const Dab& d : dabs_) f -= d(p);
  return f;
}

}  // namespace dermis::builtin_head
