// SPDX-License-Identifier: MIT
#include <array>

#include "builtin_head/sculpture.h"

namespace dermis::builtin_head {
namespace {

struct Section {
  float y, half_width, half_depth, middle_z;
};
// From the base of the skull to the shoulders; the neck leans forwards going up.
constexpr std::array<Section, 8> sections = {{{-20, 55, 46, -24},
                                              {-50, 54, 45, -22},
                                              {-80, 52.5f, 45, -18},
                                              {-110, 52, 46, -14.5f},
                                              {-138, 53, 47, -14},
                                              {-158, 58, 49, -17},
                                              {-176, 70, 51.5f, -22},
                                              {-200, 98, 56, -30}}};

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

Neck::Neck() {
  // sternocleidomastoid: from behind the ear to the pit of the neck, and the hollow before it
  strokes_.emplace_back(std::vector<vec3>{{58, -46, -22},
                                          {55, -72, -14},
                                          {50, -98, -2},
                                          {42, -125, 10},
                                          {30, -152, 21},
                                          {15, -178, 27},
                                          {12, -192, 27}},
                        Stroke::Brush{15, 3.4f, 0.15f, 0, false});
  strokes_.emplace_back(std::vector<vec3>{{49, -86, 14}, {40, -108, 20}, {28, -134, 27}, {17, -160, 29}},
                        Stroke::Brush{12, -1.8f, 0.3f, 0.4f, false});

  // trapezius
  strokes_.emplace_back(std::vector<vec3>{{20, -60, -66}, {36, -110, -56}, {58, -150, -46}, {88, -184, -36}},
                        Stroke::Brush{26, 3.5f, 0.3f, 0, false});

  // clavicle
  strokes_.emplace_back(std::vector<vec3>{{13, -183, 26}, {34, -180, 23}, {58, -177, 12}, {84, -174, -4}},
                        Stroke::Brush{10, 2.6f, 0.15f, 0.2f, false});

  dabs_ = {
      {{0, -142, 27}, {12, 13, 14}, 3.0f},   // larynx
      {{0, -126, 28}, {22, 10, 16}, -1.2f},  // above it
      {{52, -170, 6}, {24, 13, 22}, -4.0f},  // hollow over the clavicle
      {{0, -86, -67}, {14, 40, 16}, -1.6f},  // nape
  };
}

float Neck::mass(const vec3& p) const {
  const Section s = section_at(p.y);
  const vec2 q(p.x, p.z - s.middle_z), r(s.half_width, s.half_depth);
  const float k0 = glm::length(q / r), k1 = glm::length(q / (r * r));
  const float round = k1 > 1e-6f ? k0 * (k0 - 1) / k1 : -std::min(r.x, r.y);
  // Ends inside the skull.
  return soft_max(0.9f * round, p.y + 30.0f, 20.0f);
}

float Neck::add_muscles(float f, const vec3& p) const {
  if (p.y > -30) return f;
  for (const Stroke& s : strokes_) f -= s(p);
  for (const Dab& d : dabs_) f -= d(p);
  return f;
}

}  // namespace dermis::builtin_head
