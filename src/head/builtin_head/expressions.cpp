// SPDX-License-Identifier: MIT
#include "head/builtin_head/expressions.h"

#include "head/builtin_head/landmarks.h"
#include "head/builtin_head/openings.h"

namespace dermis::builtin_head {
namespace {

float ball(const vec3& p, const vec3& centre, const vec3& radii) {
  const vec3 d = (p - centre) / radii;
  return falloff(glm::dot(d, d));
}

// Returns y of a curve whose points run outwards.
float height_at(const std::vector<vec3>& curve, float x) {
  std::size_t i = 0;
  while (i + 2 < curve.size() && curve[i + 1].x < x) ++i;
  const float t = std::clamp((x - curve[i].x) / std::max(curve[i + 1].x - curve[i].x, 1e-4f), 0.0f, 1.0f);
  return glm::mix(curve[i].y, curve[i + 1].y, t);
}

vec3 turned_about_x(const vec3& p, const vec3& centre, float angle) {
  const vec3 d = p - centre;
  const float c = std::cos(angle), s = std::sin(angle);
  return centre + vec3(d.x, c * d.y - s * d.z, s * d.y + c * d.z);
}

constexpr float corner_mm = 25.8f;  // of the mouth

// The upper lid rolls down over the globe; the skin of its fold follows less the further up it is.
vec3 blink(const vec3& p, const Attachment& at) {
  const vec3 d = p - eye_centre;
  if (std::abs(d.x) > 20 || d.z < -6 || std::abs(d.y) > 19) return vec3(0);
  const float upper = height_at(upper_lid, p.x), lower = height_at(lower_lid, p.x);

  const bool is_upper = at.lid > 0 || (at.lid == 0 && p.y > 0.5f * (upper + lower));
  if (is_upper) {
    float share = at.lid > 0 ? (at.lid >= 2 ? 1.0f : 0.6f) : 1 - smooth_step(0.5f, 9.0f, p.y - upper);
    share *= at.lid == 0 ? smooth_step(4.0f, 8.0f, d.z) : 1.0f;
    return turned_about_x(p, eye_centre, share * blink_turn(p.x)) - p;
  }
  const float share = at.lid < 0 ? (at.lid <= -2 ? 1.0f : 0.6f) : 1 - smooth_step(0.5f, 8.0f, lower - p.y);
  return vec3(0, 0.9f * share * smooth_step(0, 4, upper - lower), 0);
}

vec3 smile(const vec3& p) {
  // Corners draw outwards and up; the cheeks rise before them and push the lower lids.
  const float corner = ball(p, {27, -69, 84}, {30, 24, 34});
  vec3 move = vec3(6.5f, 7.0f, -5.5f) * corner;
  move += vec3(0.8f, 4.0f, 2.8f) * ball(p, {38, -37, 80}, {25, 24, 34});
  move += vec3(0, 0.8f, 0.2f) * ball(p, {31, -11, 80}, {18, 8, 20});
  // The lips' middle is drawn flat against the teeth.
  move += vec3(0.10f * p.x, 0.4f, -1.3f) * ball(p, {0, -69, 97}, {24, 15, 26});
  return move;
}

vec3 pucker(const vec3& p) {
  const float lips = ball({std::abs(p.x), p.y, p.z}, {0, -69, 92}, {52, 32, 48});
  return {-0.48f * p.x * lips, -0.10f * (p.y + 69) * lips, 6.5f * lips};
}

vec3 brows_up(const vec3& p) {
  return vec3(0, 6.5f, 0.4f) * ball(p, {30, 20, 86}, {40, 17, 42}) +
         vec3(0, 2.4f, 0) * ball(p, {20, 44, 86}, {46, 26, 50});
}

}  // namespace

float blink_turn(float x) {
  const float upper = height_at(upper_lid, x) + 0.35f, lower = height_at(lower_lid, x) + 0.9f;
  const float dx = x - eye_centre.x, reach = std::sqrt(std::max(14.1f * 14.1f - dx * dx, 4.0f));
  const auto elevation = [&](float y) {
    return std::asin(std::clamp((y - eye_centre.y) / reach, -0.95f, 0.95f));
  };
  return std::max(0.0f, elevation(upper) - elevation(lower));
}

float jaw_share(const vec3& q, const Attachment& at) {
  const float x = std::abs(q.x);
  // From the joint to the corner of the mouth, and on along the seam of the lips.
  const float seam = height_at(mouth_line, std::min(x, corner_mm));
  const float line = q.z > 84 ? seam : seam + (84 - q.z) * 0.55f;
  const float below = line - q.y;

  // The corners go half the way; between them the lips part along two arches. Over the cheeks it is soft.
  const float soft = 14.0f + 0.15f * std::max(x - corner_mm, 0.0f);
  float share = smooth_step(-soft, soft, below);
  const bool is_lip = x < corner_mm && q.z > 60;
  if (is_lip) {
    const float arch = std::sqrt(1 - x * x / (corner_mm * corner_mm));
    const float near = 1 - smooth_step(0, soft, std::abs(below));
    const bool is_lower = at.lip != 0 ? at.lip < 0 : below > 0;
    const float edge = 0.5f * (1 - arch) * (at.lip != 0 ? 1.0f : near);
    share = is_lower ? 1 - edge : edge;
  }

  // The neck follows a little under the chin, the skin behind the joint not at all.
  share *= smooth_step(-138, -98, q.y + 0.35f * q.z);
  return share * smooth_step(-14, 14, q.z);
}

vec3 displacement(Expression expression, const vec3& q, const Attachment& at) {
  const float side = q.x < 0 ? -1.0f : 1.0f;
  const vec3 p(std::abs(q.x), q.y, q.z);
  vec3 move(0);
  switch (expression) {
    case Expression::blink_left: move = side > 0 ? blink(p, at) : vec3(0); break;
    case Expression::blink_right: move = side < 0 ? blink(p, at) : vec3(0); break;
    case Expression::jaw_open:
      move = jaw_share(p, at) * (turned_about_x(p, jaw_joint, jaw_open_rad) - p);
      break;
    case Expression::smile: move = smile(p); break;
    case Expression::brows_up: move = brows_up(p); break;
    case Expression::pucker: move = pucker(p); break;
  }
  return {side * move.x, move.y, move.z};
}

}  // namespace dermis::builtin_head
