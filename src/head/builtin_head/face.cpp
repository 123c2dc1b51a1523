// SPDX-License-Identifier: MIT
// The face, on the left half: what a sculptor lays on the skull, in his order: planes, eyes, nose, mouth.
#include "head/builtin_head/landmarks.h"
#include "head/builtin_head/sculpture.h"

namespace dermis::builtin_head {
namespace {

// The closed surface of both lids over the eyeball, about 2 mm thick; Openings cuts it open.
const vec3 lids_centre(31.4f, -0.6f, 67.0f);
const vec3 lids_radii(16.2f, 13.4f, 14.0f);

std::vector<Dab> planes() {
  return {
      {{9, 19, 94}, {17, 9, 20}, 1.3f},          // glabella and inner brow
      {{30, 19, 90}, {21, 8, 20}, 1.0f},         // superciliary ridge
      {{49, 12, 76}, {12, 11, 18}, 1.0f},        // its outer end
      {{0, 48, 90}, {34, 20, 30}, 0.8f},         // frontal eminence
      {{33, 52, 80}, {20, 18, 26}, 1.0f},        //
      {{15.5f, 5.5f, 79}, {8, 8, 16}, -1.6f},    // inner hollow of the orbit
      {{45, 8.5f, 74}, {13, 7, 18}, 1.5f},       // soft fold over the outer lid
      {{30, 11, 80}, {16, 7, 18}, 0.7f},         // and over its middle
      {{31, -13.5f, 78}, {17, 6, 14}, 0.6f},     // lower lid
      {{62, 20, 42}, {16, 26, 24}, -1.6f},       // temple
      {{48, -21, 73}, {20, 13, 22}, 1.9f},       // cheekbone
      {{62, -17, 50}, {16, 11, 26}, 0.9f},       // its arch
      {{53, -50, 50}, {18, 22, 30}, -1.8f},      // below it
      {{30, -33, 82}, {14, 15, 18}, 1.6f},       // front of the cheek
      {{33, -70, 79}, {12, 13, 16}, 0.7f},       // pad beside the mouth
      {{27.0f, -70.5f, 83}, {7, 6, 12}, -0.7f},  // corner of the mouth
      {{0, -87.5f, 92}, {24, 7, 14}, -1.8f},     // fold over the chin
      {{9, -102, 94}, {13, 11, 16}, 1.6f},       // chin, a pad on each side
      {{24, -97, 84}, {11, 12, 16}, -0.9f},      // before the pad
      {{49, -84, 18}, {12, 14, 20}, 1.5f},       // angle of the jaw
  };
}

// From the wing of the nose past the mouth, the cheek's edge beside it, and down from the corner of the
// mouth.
std::vector<Stroke> folds() {
  return {
      {{{16.5f, -38, 92}, {21, -45, 89}, {26, -54, 85}, {30.5f, -64, 80}, {32, -73, 77}},
       {9.0f, -0.9f, 0.2f, 0.7f}},
      {{{19, -33, 88}, {26, -44, 85}, {32, -54, 80}, {37, -65, 75}}, {11.0f, 0.7f, 0.3f, 0.6f}},
      {{{28, -74, 82}, {30, -82, 79}, {31, -91, 76}}, {7.0f, -0.4f, 0.3f, 0.7f}},
  };
}

// Crease of the upper lid and the fold above it, the hollow below, the lower lid's edge.
std::vector<Stroke> lid_strokes() {
  return {
      {upper_crease, {4.2f, -1.2f, 0.25f, 0.4f}},
      {{{16, 7, 80}, {23, 11.4f, 81}, {32, 12.9f, 81}, {41, 10.3f, 78}, {48, 5.9f, 72}, {53, 0.3f, 66}},
       {6.0f, 1.5f, 0.35f, 0.3f}},
      {tear_trough, {5.5f, -0.5f, 0.2f, 0.7f}},
      {lower_crease, {3.2f, -0.35f, 0.3f, 0.4f}},
  };
}

// Sharper: the crease, the roll of the lower lid under its edge, fine folds.
std::vector<Stroke> lid_creases() {
  return {
      {upper_crease, {1.5f, -0.55f, 0.2f, 0.4f}},
      {{{19, -7.0f, 77}, {26, -9.0f, 80}, {33, -9.3f, 80}, {40, -8.0f, 77}, {45, -5.2f, 73}},
       {1.6f, 0.12f, 0.2f, 0.3f}},
      {{{20, -15.0f, 77}, {27, -18.2f, 78}, {35, -18.6f, 78}, {42, -16, 75}}, {1.4f, -0.16f, 0.4f, 0.5f}},
  };
}

// Around the wing.
std::vector<Stroke> nose_strokes() {
  return {
      {{{9.8f, -35.5f, 106},
        {14.2f, -36.0f, 100},
        {17.6f, -39.5f, 93},
        {17.8f, -44.5f, 90},
        {15, -48.4f, 90}},
       {4.2f, -1.0f, 0.45f, 0.3f}},
  };
}

// The parting, and the philtrum: two ridges and the groove between.
std::vector<Stroke> mouth_strokes() {
  return {
      {mouth_line, {2.8f, -0.6f, 0, 0.15f}},
      {{{4.6f, -48.5f, 100}, {5.0f, -54, 100}, {5.6f, -59.5f, 102}}, {4.2f, 0.7f, 0.3f, 0}},
      {{{0, -48.5f, 100}, {0, -54, 100}, {0, -60, 102}}, {4.6f, -0.9f, 0.35f, 0.1f}},
  };
}

// The parting's depth, the borders of the red, the middle of the lower lip.
std::vector<Stroke> mouth_creases() {
  return {
      {mouth_line, {1.3f, -0.6f, 0, 0.12f}},
      {upper_border, {1.3f, 0.34f, 0, 0.3f}},
      {lower_border, {1.6f, 0.22f, 0, 0.4f}},
      {{{0, -70, 99}, {0, -74, 99}, {0, -78, 98}}, {2.2f, -0.35f, 0.4f, 0.5f}},
  };
}

}  // namespace

Face::Face()
    : planes_(planes()),
      folds_(folds()),
      lid_strokes_(lid_strokes()),
      lid_creases_(lid_creases()),
      nose_strokes_(nose_strokes()),
      mouth_strokes_(mouth_strokes()),
      mouth_creases_(mouth_creases()),
      bridge_({{{0, 7, 82.5f}, 6.0f},
               {{0, 0, 83.0f}, 5.6f},
               {{0, -9, 88.5f}, 6.0f},
               {{0, -18, 96.2f}, 6.6f},
               {{0, -27, 102.2f}, 7.2f},
               {{0, -34, 106.0f}, 8.0f}}),
      nose_core_({{{0, 4, 72}, 6.5f},
                  {{0, -8, 75}, 9.0f},
                  {{0, -22, 80}, 12.0f},
                  {{0, -33, 86}, 13.6f},
                  {{0, -36.5f, 88}, 13.0f}}),
      columella_({{{0, -43.2f, 110}, 3.0f}, {{0, -45.2f, 104}, 2.8f}, {{0, -47, 96.5f}, 3.4f}}),
      ala_({{{7.5f, -40.5f, 107}, 4.2f},
            {{11.2f, -41.2f, 103}, 4.4f},
            {{13.4f, -41.8f, 97.5f}, 5.0f},
            {{13.2f, -43.0f, 92.5f}, 4.6f},
            {{11.0f, -45.5f, 90}, 3.4f}}),
      upper_lip_({{{0, -65.2f, 96.6f}, 4.6f},
                  {{5, -64.6f, 96.0f}, 4.7f},
                  {{11, -65.9f, 93.4f}, 4.1f},
                  {{18, -68.0f, 88.4f}, 3.0f},
                  {{25.5f, -70.0f, 82.2f}, 1.6f}}),
      lower_lip_({{{0, -74.0f, 94.6f}, 5.6f},
                  {{6, -73.8f, 94.0f}, 5.5f},
                  {{12, -73.0f, 91.4f}, 4.9f},
                  {{18, -71.8f, 87.4f}, 3.8f},
                  {{25.5f, -70.6f, 82.0f}, 1.8f}}) {
  eye_.origin = lids_centre;  // turned outwards by 9 degrees, outer corner a little higher
  eye_.x = glm::normalize(vec3(0.987f, 0.05f, -0.156f));
  eye_.z = glm::normalize(glm::cross(eye_.x, vec3(0, 1, 0)));
  eye_.y = glm::cross(eye_.z, eye_.x);

  nostril_.origin = {7.6f, -46.9f, 101.0f};
  nostril_.z = glm::normalize(vec3(-0.42f, 0.30f, 0.86f));
  nostril_.x = glm::normalize(glm::cross(vec3(0, 1, 0), nostril_.z));
  nostril_.y = glm::cross(nostril_.z, nostril_.x);
}

float Face::add_planes(float f, const vec3& p) const {
  for (const Dab& dab : planes_) f -= dab(p);
  for (const Stroke& fold : folds_) f -= fold(p);
  return f;
}

float Face::add_eye(float f, const vec3& p, Detail detail) const {
  const vec3 d = p - lids_centre;
  if (std::abs(d.x) > 32 || std::abs(d.y) > 30 || d.z < -22) return f;
  f = soft_min(f, ellipsoid(eye_.to_local(p), lids_radii), 5.0f);
  for (const Stroke& s : lid_strokes_) f -= s(p);
  if (detail == Detail::fine) {
    for (const Stroke& s : lid_creases_) f -= s(p);
  }
  return f;
}

float Face::add_nose(float f, const vec3& p, Detail detail) const {
  if (p.x > 36 || p.y > 28 || p.y < -66 || p.z < 60) return f;
  f = soft_min(f, nose_core_(p, f + 12), 12);
  f = soft_min(f, bridge_(p, f + 9), 9);
  f = soft_min(f, ellipsoid(p - vec3(1.5f, -36.6f, 107.0f), {8.2f, 8.2f, 10.0f}), 9.0f);
  f = soft_min(f, ala_(p, f + 3.6f), 3.6f);
  f = soft_min(f, columella_(p, f + 3), 3);
  if (detail == Detail::blunt) return f;
  f = soft_max(f, -ellipsoid(nostril_.to_local(p), {3.3f, 5.2f, 6.2f}), 2.2f);
  for (const Stroke& s : nose_strokes_) f -= s(p);
  return f;
}

float Face::add_mouth(float f, const vec3& p, Detail detail) const {
  if (p.x > 42 || p.y > -44 || p.y < -92 || p.z < 60) return f;
  const float far = f + 6.4f;  // the fillets of both unions
  const float lips = soft_min(upper_lip_(p, far), lower_lip_(p, far), 2.4f);
  f = soft_min(f, lips, 4.0f);
  for (const Stroke& s : mouth_strokes_) f -= s(p);
  if (detail == Detail::fine) {
    for (const Stroke& s : mouth_creases_) f -= s(p);
  }
  return f;
}

float Face::add(float f, const vec3& p, Detail detail) const {
  f = add_planes(f, p);
  f = add_eye(f, p, detail);
  f = add_mouth(f, p, detail);
  f = add_nose(f, p, detail);
  // The fillets around the eye have filled its corners.
  return f -
         Dab{{15.5f, -2.0f, 79}, {9.5f, 10, 16}, -4.6f}(p)-Dab{{50.5f, -3.0f, 70}, {16, 14, 22}, -4.8f}(p);
}

}  // namespace dermis::builtin_head
