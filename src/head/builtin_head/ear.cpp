// SPDX-License-Identifier: MIT
// The ear: a leaning plate on a root, its rim (helix) rolled outwards, the inner fold (antihelix) with its
// two legs, the bowl (concha), the flap before it (tragus), its counterpart below, and the lobe.
#include "head/builtin_head/sculpture.h"

namespace dermis::builtin_head {

Ear::Ear()
    : helix_({{{-1.5f, -2.0f, -2.6f}, 2.4f},
              {{-8, 2.2f, -0.4f}, 2.8f},
              {{-13.5f, 11, 2.0f}, 2.8f},
              {{-12.5f, 21, 2.6f}, 2.7f},
              {{-5, 28.5f, 3.2f}, 2.8f},
              {{4.5f, 30, 3.8f}, 2.9f},
              {{13.2f, 25.5f, 4.8f}, 2.8f},
              {{17.2f, 16.0f, 5.2f}, 2.7f},
              {{17.0f, 5, 5.0f}, 2.5f},
              {{14.2f, -5, 3.9f}, 2.3f},
              {{9.6f, -14, 2.4f}, 2.3f},
              {{5.2f, -20.5f, 1.0f}, 2.6f}}),
      antihelix_({{{-2.5f, -16, 2.8f}, 2.9f},
                  {{3.4f, -14, 3.2f}, 2.7f},
                  {{8.0f, -7, 4.4f}, 2.8f},
                  {{9.6f, 2, 5.0f}, 2.9f},
                  {{8.4f, 10, 4.6f}, 3.0f},
                  {{6.4f, 17.5f, 3.2f}, 2.8f},
                  {{5.2f, 23, 1.6f}, 2.2f}}),
      inferior_crus_({{{8.0f, 10, 4.0f}, 2.6f},
                      {{3, 12.2f, 2.8f}, 2.3f},
                      {{-3, 13.0f, 1.6f}, 2.1f},
                      {{-8.5f, 13.0f, 0.8f}, 1.8f}}),
      lobe_rim_({{{7.2f, -17.5f, 2.6f}, 3.0f},
                 {{3.4f, -25.0f, 1.8f}, 3.4f},
                 {{-2.5f, -28.5f, 1.0f}, 3.5f},
                 {{-8, -26, 0.2f}, 3.2f},
                 {{-11, -19, -0.4f}, 2.8f}}) {
  // Axis 14 degrees back from the vertical, plate 27 degrees from the side of the head.
  frame_.origin = {75.0f, -14.0f, -13.0f};
  frame_.y = glm::normalize(vec3(0.10f, 0.965f, -0.24f));
  const vec3 back = vec3(0.39f, -0.1f, -0.91f);
  frame_.x = glm::normalize(back - glm::dot(back, frame_.y) * frame_.y);
  frame_.z = glm::cross(frame_.x, frame_.y);
  if (frame_.z.x < 0) frame_.z = -frame_.z;  // outwards; a mirrored frame is as good

  hollows_ = {
      {{12.6f, 9, 6.0f}, {3.6f, 17, 7}, -2.3f},      // the groove between rim and inner fold
      {{1.5f, 18.0f, 4}, {6.0f, 5.0f, 6}, -2.2f},    // between the legs of the fold
      {{-10.5f, -1.4f, 4}, {3.2f, 2.6f, 5}, -1.4f},  // notch over the tragus
      {{-7.5f, -14.0f, 4}, {3.2f, 3.6f, 5}, -1.8f},  // notch under it
  };
}

float Ear::add(float f, const vec3& p, Detail detail) const {
  const vec3 q = frame_.to_local(p);
  if (std::abs(q.x) > 34 || std::abs(q.y) > 46 || std::abs(q.z) > 26) return f;
  // Root: fills most of the groove behind the ear, which a mesh without undercuts could not follow.
  f = soft_min(f, ellipsoid(q - vec3(0.0f, 1.5f, -6.5f), {15.0f, 27.0f, 9.5f}), 4.5f);
  if (detail == Detail::blunt)
    return soft_min(f, ellipsoid(q - vec3(2.0f, 1.0f, 2.0f), {21.0f, 34.0f, 9.0f}), 6.0f);

  // The plate is a dish: its edge stands out and carries the rim.
  const vec2 r((q.x - 1.5f) / 17.0f, (q.y - 3.5f) / 27.0f);
  const float dish = 3.4f * std::min(glm::dot(r, r), 1.6f);
  float ear = ellipsoid(q - vec3(1.5f, 5.5f, dish - 0.6f), {17.6f, 26.0f, 4.2f});
  ear = soft_min(ear, ellipsoid(q - vec3(-2.5f, -22.5f, 0.0f), {9.5f, 8.5f, 3.2f}), 3.5f);
  f = soft_min(f, ear, 5.0f);

  f = soft_max(f, -ellipsoid(q - vec3(-2.4f, -5.2f, 5.5f), {9.8f, 10.6f, 9.6f}), 3.0f);  // bowl, lower part
  f = soft_max(f, -ellipsoid(q - vec3(-0.6f, 6.6f, 5.0f), {8.6f, 4.8f, 7.0f}), 2.6f);    // bowl, upper part
  f = soft_min(f, helix_(q, f + 2.0f), 2.0f);
  f = soft_min(f, antihelix_(q, f + 2.4f), 2.4f);
  f = soft_min(f, inferior_crus_(q, f + 2.2f), 2.2f);
  f = soft_min(f, lobe_rim_(q, f + 3.6f), 3.6f);

  // where the lobe grows from the jaw
  f = soft_min(f, ellipsoid(q - vec3(-9.5f, -21.0f, -4.0f), {6.0f, 9.0f, 5.5f}), 7.0f);
  f = soft_min(f, ellipsoid(q - vec3(-11.2f, -6.8f, 3.2f), {3.4f, 5.2f, 4.0f}), 2.6f);  // tragus

  for (const Dab& d : hollows_) f -= d(q);
  if (detail == Detail::fine) f -= Dab{{-1.5f, -20.5f, 3.2f}, {6, 4, 5}, -0.5f}(q);
  return f;
}

}  // namespace dermis::builtin_head
