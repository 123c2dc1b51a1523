// SPDX-License-Identifier: MIT
// Measures the built-in head as anthropometry does and holds it within one standard deviation of published
// means.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "anthropometry.h"
#include "head/builtin_head/builtin_head.h"
#include "head/builtin_head/openings.h"
#include "head/builtin_head/sculpture.h"
#include "support/built_in.h"

namespace dermis::builtin_head {
namespace {

namespace a = anthropometry;
using glm::dvec3;

// A vertex in mm, y from the line of the eyes.
dvec3 point(const scene::Vertex& v) {
  return dvec3(v.position_m) * 1000.0 - dvec3(0, Sculpture::eyes_over_origin_mm, 0);
}
dvec3 node(int column, int row) {
  const auto stride = static_cast<std::size_t>(Openings::columns + 1);
  return point(tests::built_in_head().primitives.front().vertices[static_cast<std::size_t>(row) * stride +
                                                                  static_cast<std::size_t>(column)]);
}

struct Box {
  dvec3 low, high;
};
// The corners of a box about the skin within another.
Box skin_within(const Box& box) {
  Box found{dvec3(1e9), dvec3(-1e9)};
  for (const scene::Vertex& v : tests::built_in_head().primitives.front().vertices) {
    const dvec3 p = point(v);
    if (glm::any(glm::lessThan(p, box.low)) || glm::any(glm::greaterThan(p, box.high))) continue;
    found.low = glm::min(found.low, p);
    found.high = glm::max(found.high, p);
  }
  return found;
}

// The profile: the frontmost skin of the midline at a height.
double profile_z(double y) {
  double z = -1000;
  const scene::Primitive& skin = tests::built_in_head().primitives.front();
  for (std::size_t t = 0; t < skin.indices.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3 p = point(skin.vertices[skin.indices[t + k]]),
                  q = point(skin.vertices[skin.indices[t + (k + 1) % 3]]);
      if ((p.y < y) == (q.y < y) || std::abs(p.x) > 3 || std::abs(q.x) > 3) continue;
      z = std::max(z, glm::mix(p.z, q.z, (y - p.y) / (q.y - p.y)));
    }
  }
  return z;
}

// Deepest point of the root of the nose.
dvec3 sellion() {
  dvec3 deepest(0, 0, 1e9);
  for (double y = -6; y < 14; y += 0.5) {
    if (const double z = profile_z(y); z < deepest.z) deepest = {0, y, z};
  }
  return deepest;
}

// Where the partition of the nose meets the lip: the point farthest behind a line from one to the other.
dvec3 subnasale() {
  const dvec3 nose(0, -45, profile_z(-45)), lip(0, -62, profile_z(-62));
  const dvec3 behind = glm::normalize(glm::cross(lip - nose, dvec3(1, 0, 0)));
  const double sign = behind.z < 0 ? 1.0 : -1.0;
  dvec3 found = nose;
  double farthest = -1e9;
  for (double y = -61; y < -45; y += 0.25) {
    const dvec3 p(0, y, profile_z(y));
    if (const double d = sign * glm::dot(p - nose, behind); d > farthest) {
      farthest = d;
      found = p;
    }
  }
  return found;
}

dvec3 pupil(double side) {
  dvec3 apex(0, 0, -1e9);
  for (const scene::Primitive& part : tests::built_in_head().primitives) {
    if (part.name != "eyes") continue;
    for (const scene::Vertex& v : part.vertices) {
      if (const dvec3 p = point(v); p.x * side > 0 && p.z > apex.z) apex = p;
    }
  }
  return apex;
}

void expect(const a::Measure& measure, double got_mm) {
  testing::Test::RecordProperty(measure.name, std::to_string(got_mm));
  EXPECT_NEAR(got_mm, measure.mean_mm, measure.deviation_mm) << measure.name;
}

TEST(Proportions, OfTheSkullAreWithinOneStandardDeviation) {
  const Box vault = skin_within({{-200, 20, -200}, {200, 120, 200}});
  expect(a::head_breadth, vault.high.x - vault.low.x);

  const Box midline = skin_within({{-10, 5, -200}, {10, 60, 200}});
  expect(a::head_length, midline.high.z - midline.low.z);

  const Box cheekbones = skin_within({{-200, -28, 12}, {200, -4, 60}});
  expect(a::bizygomatic_breadth, cheekbones.high.x - cheekbones.low.x);

  const Box jaw = skin_within({{-200, -92, 6}, {200, -78, 40}});
  expect(a::bigonial_breadth, jaw.high.x - jaw.low.x);

  const Box chin = skin_within({{-10, -130, 62}, {10, -90, 200}});
  expect(a::menton_sellion, sellion().y - chin.low.y);
}

TEST(Proportions, OfTheNoseAndTheMouthAreWithinOneStandardDeviation) {
  expect(a::subnasale_sellion, glm::distance(sellion(), subnasale()));
  const Box nose = skin_within({{-30, -50, 92}, {30, -36, 110}});
  expect(a::nose_breadth, nose.high.x - nose.low.x);
  const Box tip = skin_within({{-6, -50, 60}, {6, -25, 200}});
  expect(a::nose_protrusion, tip.high.z - subnasale().z);

  constexpr Opening mouth = Openings::mouth;
  expect(a::lip_length, glm::distance(node(mouth.from, mouth.middle), node(mouth.to, mouth.middle)));
}

TEST(Proportions, OfTheEyesAreWithinOneStandardDeviation) {
  constexpr Opening eye = Openings::eye;
  constexpr int last = Openings::columns, half = Openings::half;
  expect(a::interpupillary_distance, pupil(1).x - pupil(-1).x);
  expect(a::intercanthal_width, glm::distance(node(eye.from, eye.middle), node(last - eye.from, eye.middle)));
  expect(a::biocular_width, node(eye.to, eye.middle).x - node(last - eye.to, eye.middle).x);

  for (const bool left : {true, false}) {
    const auto at = [&](int column, int row) { return node(left ? column : last - column, row); };
    expect(a::eye_fissure_length, glm::distance(at(eye.from, eye.middle), at(eye.to, eye.middle)));
    double height = 0;
    for (int i = eye.from; i <= eye.to; ++i)
      height = std::max(height, at(i, eye.middle + half).y - at(i, eye.middle - half).y);
    expect(a::eye_fissure_height, height);
  }
}

TEST(Proportions, OfTheEarsAreWithinOneStandardDeviation) {
  const Box left = skin_within({{77, -80, -60}, {120, 60, 30}});
  const Box right = skin_within({{-120, -80, -60}, {-77, 60, 30}});
  expect(a::ear_length, left.high.y - left.low.y);
  expect(a::ear_length, right.high.y - right.low.y);
}

TEST(Proportions, FollowTheCanonOfTheFace) {
  // The line of the eyes halves the head; an eye is as wide as the gap between both, and as the nose.
  const Box skull = skin_within({{-40, 60, -80}, {40, 140, 80}});
  const Box chin = skin_within({{-10, -130, 62}, {10, -90, 200}});
  EXPECT_NEAR(skull.high.y / -chin.low.y, 1.0, 0.06);

  constexpr Opening eye = Openings::eye;
  const double gap = node(eye.from, eye.middle).x - node(Openings::columns - eye.from, eye.middle).x,
               width = node(eye.to, eye.middle).x - node(eye.from, eye.middle).x;
  EXPECT_NEAR(width / gap, 1.0, 0.15);

  // Both halves differ a little, as every face's do.
  const double tilt = pupil(1).y - pupil(-1).y;
  EXPECT_GT(std::abs(tilt), 0.2);
  EXPECT_LT(std::abs(tilt), 2.5);
}

}  // namespace
}  // namespace dermis::builtin_head
