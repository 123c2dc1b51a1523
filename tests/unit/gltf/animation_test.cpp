// SPDX-License-Identifier: MIT
// Animated files, in the pose of a clip at a time.
#include <algorithm>
#include <cmath>
#include <functional>

#include "head/scene/placement.h"
#include "head/scene/rig/animation.h"
#include "posed_by_hand.h"
#include "support.h"
#include "support/sanitized.h"

namespace dermis::scene::test {
namespace {

constexpr double half = 0.70710678118654752;

KeyFrames ramp(Interpolation interpolation) {
  return {.interpolation = interpolation, .times_s = {1, 2, 4}, .size = 2, .values = {0, 10, 4, 10, 8, 30}};
}

TEST(KeyFramesOfAnimations, HoldStepAndGoStraight) {
  const KeyFrames linear = ramp(Interpolation::linear), step = ramp(Interpolation::step);
  EXPECT_EQ(value_at(linear, -5), (std::vector<double>{0, 10})) << "before the first key, its value";
  EXPECT_EQ(value_at(linear, 1), (std::vector<double>{0, 10}));
  EXPECT_EQ(value_at(linear, 1.25), (std::vector<double>{1, 10}));
  EXPECT_EQ(value_at(linear, 3.5), (std::vector<double>{7, 25}));
  EXPECT_EQ(value_at(linear, 9), (std::vector<double>{8, 30})) << "after the last";
  EXPECT_EQ(value_at(step, 1.999), (std::vector<double>{0, 10}));
  EXPECT_EQ(value_at(step, 2), (std::vector<double>{4, 10}));
}

// x^3 between 1 and 3: a cubic is its own Hermite spline.
TEST(KeyFramesOfAnimations, CubicSplinesAreCubics) {
  const KeyFrames keys{.interpolation = Interpolation::cubic_spline,
                       .times_s = {1, 3},
                       .size = 1,
                       .values = {99, 1, 3, 27, 27, 99}};
  for (const double x : {1.0, 1.3, 2.0, 2.9, 3.0}) EXPECT_NEAR(value_at(keys, x)[0], x * x * x, 1e-12) << x;
}

TEST(KeyFramesOfAnimations, RotationsTakeTheShorterArc) {
  // From 0 to 90 degrees about y, the second with the other sign, which is the same rotation.
  const KeyFrames keys{.times_s = {0, 1},
                       .size = 4,
                       .values = {0, 0, 0, 1, 0, static_cast<float>(-half), 0, static_cast<float>(-half)}};
  const glm::dvec3 turned = rotation_at(keys, 1.0 / 3) * glm::dvec3(0, 0, 1);
  EXPECT_NEAR(turned.x, 0.5, 1e-6) << "sine of 30 degrees";
  EXPECT_NEAR(turned.z, std::sqrt(0.75), 1e-6);
  EXPECT_NEAR(glm::length(rotation_at(keys, 0.7)), 1, 1e-12);
}

TEST(Poses, BlendBetweenTwoClips) {
  const auto moved_to = [](float x, float w) {
    return Clip{.name = "",
                .key_frames = {{.times_s = {0}, .size = 3, .values = {x, 0, 0}},
                               {.times_s = {0}, .size = 1, .values = {w}}},
                .channels = {{0, 1, AnimatedPath::translation}, {1, 1, AnimatedPath::weights}}};
  };
  Pose rest(2), a, b;
  rest[1].weights = {0};
  a = b = rest;
  play(moved_to(2, 1), 0, a);
  play(moved_to(4, 0), 0, b);
  const Pose between = blended(a, b, 0.25);
  EXPECT_NEAR(between[1].transform.translation.x, 2.5, 1e-12);
  EXPECT_NEAR(between[1].weights[0], 0.75, 1e-12);
  EXPECT_NEAR(between[0].transform.translation.x, 0, 1e-12);
}

struct Compared {
  double farthest = 0, size = 0, moved = 0;  ///< m; moved: from the pose at rest
};

double distance(const glm::dvec3& a, const PosedByHand::Point& b) {
  return glm::distance(a, glm::dvec3(b[0], b[1], b[2]));
}

Compared compare(const fs::path& file, const PosedByHand& by_hand, double seconds) {
  const AssetData scene = load_gltf(file, {.time_s = seconds}), rest = load_gltf(file);
  const auto expected = by_hand.positions_m(0, seconds);
  Compared c;
  glm::dvec3 low(1e9), high(-1e9);
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    const Primitive& primitive = scene.primitives[k];
    const std::vector<PosedByHand::Point>& by_number =
        expected.at(static_cast<std::size_t>(primitive.source_mesh));
    for (std::uint32_t v = 0; v < primitive.vertices.size(); ++v) {
      const glm::dvec3 p(world_position_m(primitive, 0, v));
      if (primitive.placements.empty())
        c.farthest = std::max(c.farthest, distance(p, by_number.at(source_vertex(primitive, v))));
      if (rest.primitives.size() == scene.primitives.size() &&
          rest.primitives[k].vertices.size() == primitive.vertices.size())
        c.moved = std::max(c.moved, glm::distance(p, glm::dvec3(world_position_m(rest.primitives[k], 0, v))));
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  c.size = glm::distance(low, high);
  return c;
}

std::vector<fs::path> animated_files(const fs::path& assets) {
  std::vector<fs::path> files;
  for (const char* folder : {"gltf-valid", "makehuman", "ict-facekit"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(assets / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".gltf" && extension != ".glb") continue;
      if (read_text(entry.path()).find("\"animations\"") != std::string::npos) files.push_back(entry.path());
    }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(AnimatedFiles, StandAsAnEvaluationByHandHasThem) {
  DERMIS_NEED_ASSETS(folder);
  const Warnings quiet;
  std::size_t compared = 0, moving = 0;
  for (const fs::path& file : animated_files(*folder)) {
    SCOPED_TRACE(file.filename().string());
    if (!error_of(file).empty()) continue;  // other tests say which valid files need what is not supported
    const PosedByHand by_hand(file);
    ASSERT_GT(by_hand.animations(), 0u);
    if (by_hand.is_compressed()) {
      EXPECT_EQ(error_of(file, {.time_s = 1.0}), "");
      continue;
    }
    const double end_s = by_hand.end_s(0);
    double moved = 0;
    const int times = file.string().find("-sub1") == std::string::npos ? tests::turns(10, 4) : 2;
    for (int i = 0; i < times; ++i) {
      // Before, between and after the keys.
      const double seconds = std::max(0.0, end_s * (1.2 * i / (times - 1) - 0.05));
      const Compared c = compare(file, by_hand, seconds);
      EXPECT_LE(c.farthest, 1e-5 * c.size) << seconds << " s";
      moved = std::max(moved, c.moved / c.size);
    }
    ++compared;
    moving += moved > 1e-3 ? 1 : 0;
  }
  EXPECT_GE(compared, 12u);
  EXPECT_GE(moving, 9u) << "of the files that move at all";
}

// A triangle with a node that an animation moves, turns and scales.
class Moved : public testing::Test {
 protected:
  Moved() { b.triangle(); }

  int sampler(const std::vector<float>& times, const std::vector<float>& values, const std::string& type,
              const std::string& way = "LINEAR") {
    Json& samplers = animation()["samplers"];
    samplers.push_back({{"input", b.accessor(times, "SCALAR")},
                        {"output", b.accessor(values, type)},
                        {"interpolation", way}});
    return static_cast<int>(samplers.size()) - 1;
  }
  void channel(int sampler, const std::string& path, int node = 0) {
    animation()["channels"].push_back({{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
  }
  Json& animation() {
    if (!b.json.contains("animations"))
      b.json["animations"] = Json::array({{{"samplers", Json::array()}, {"channels", Json::array()}}});
    return b.json["animations"].back();
  }
  void moves() { channel(sampler({0, 2}, {0, 0, 0, 2, 0, 0}, "VEC3"), "translation"); }

  std::string error(std::optional<double> seconds = 1.0, const std::string& clip = "") {
    const Warnings quiet;
    return b.error({.clip = clip, .time_s = seconds});
  }

  Builder b;
};

TEST_F(Moved, StandsStillUnlessAsked) {
  moves();
  const Warnings quiet;
  expect_near(b.load().primitives[0].vertices[0].position_m, {0, 0, 0});
  expect_near(b.load({.time_s = 0.5}).primitives[0].vertices[0].position_m, {0.5f, 0, 0});
  expect_near(b.load({.time_s = 0.5}).primitives[0].vertices[1].position_m, {0.7f, 0, 0});
}

TEST_F(Moved, HasClipsByNameAndNumber) {
  moves();
  b.json["animations"].push_back(
      {{"name", "jump"}, {"samplers", Json::array()}, {"channels", Json::array()}});
  channel(sampler({0}, {0, 3, 0}, "VEC3", "STEP"), "translation");
  const Warnings quiet;
  EXPECT_EQ(b.load().clips, (std::vector<std::string>{"0", "jump"}));
  expect_near(b.load({.clip = "jump"}).primitives[0].vertices[0].position_m, {0, 3, 0});
  expect_near(b.load({.clip = "0", .time_s = 2.0}).primitives[0].vertices[0].position_m, {2, 0, 0});
  expect_near(b.load({.clip = "1"}).primitives[0].vertices[0].position_m, {0, 3, 0});
  EXPECT_ERROR(error(1.0, "run"), "has no animation 'run'; there are: 0, jump");
  EXPECT_ERROR(error(1.0, "2"), "has no animation '2'; there are: 0, jump");
}

TEST_F(Moved, OfEqualNamesTheFirstCountsAndNumbersTakeAny) {
  moves();
  b.json["animations"][0]["name"] = "walk";
  b.json["animations"].push_back(
      {{"name", "walk"}, {"samplers", Json::array()}, {"channels", Json::array()}});
  channel(sampler({0}, {0, 3, 0}, "VEC3", "STEP"), "translation");
  const Warnings warnings;
  expect_near(b.load({.clip = "walk", .time_s = 2.0}).primitives[0].vertices[0].position_m, {2, 0, 0});
  expect_near(b.load({.clip = "1"}).primitives[0].vertices[0].position_m, {0, 3, 0});
  EXPECT_TRUE(warnings.any_with("animations share the name 'walk'; a number, 0 to 1, takes any of them"))
      << warnings.all();
}

TEST_F(Moved, CarriesCamerasAndLights) {
  moves();
  b.json["cameras"] =
      Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.01}}}}});
  b.json["nodes"][0]["camera"] = 0;
  const Warnings quiet;
  EXPECT_NEAR(b.load({.time_s = 1.5}).cameras.at(0).world_from_camera[3].x, 1.5, 1e-6);
}

TEST_F(Moved, WithoutAnAnimationIsRefused) { EXPECT_ERROR(error(), "has no animation"); }

TEST_F(Moved, FaultsAreOneLine) {
  const struct {
    std::vector<float> times, values;
    std::string type, path, way, said;
  } faults[] = {
      {{1, 0.5f}, {0, 0, 0, 1, 0, 0}, "VEC3", "translation", "LINEAR", "must not fall; 0.5 s follows 1 s"},
      {{NAN}, {0, 0, 0}, "VEC3", "translation", "LINEAR", "time 0 is nan"},
      {{0}, {0, NAN, 0}, "VEC3", "translation", "LINEAR", "number 1 of its output is not finite"},
      {{0, 1}, {0, 0, 0}, "VEC3", "translation", "LINEAR", "output has 3 numbers, 2 key frames of 3 need 6"},
      {{0},
       {0, 0, 0},
       "VEC3",
       "translation",
       "CUBICSPLINE",
       "output has 3 numbers, 1 key frames of 3 need 9"},
      {{0}, {0, 0, 0, 1}, "VEC4", "scale", "STEP", "output must be VEC3 of FLOAT"},
      {{0}, {0, 0, 0}, "VEC3", "rotation", "STEP", "output must be VEC4 of FLOAT or normalised integers"},
      {{0}, {0, 0, 0, 0}, "VEC4", "rotation", "STEP", "rotation 0 has no length"},
      {{0}, {0, 0, 0}, "VEC3", "translation", "CUBIC", "must be LINEAR, STEP or CUBICSPLINE, is \"CUBIC\""},
  };
  for (const auto& fault : faults) {
    Builder fresh;
    b.json = fresh.json, b.bytes = fresh.bytes;
    b.triangle();
    channel(sampler(fault.times, fault.values, fault.type, fault.way), fault.path);
    EXPECT_ERROR(error(), fault.said);
  }
}

TEST_F(Moved, FaultyReferencesAreOneLine) {
  moves();
  Json& attributes = b.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = b.accessor(std::vector<float>(12, 0), "VEC4", 5121);
  attributes["WEIGHTS_0"] = b.accessor(std::vector<float>(12, 0.25f), "VEC4");
  const Json sound = b.json;
  const struct {
    std::function<void(Json&)> spoil;
    std::string said;
  } faults[] = {
      {[](Json& j) { j["animations"][0]["channels"][0]["sampler"] = 7; }, "sampler"},
      {[](Json& j) { j["animations"][0]["channels"][0].erase("sampler"); }, "sampler"},
      {[](Json& j) { j["animations"][0]["channels"][0]["target"]["node"] = 9; }, "node"},
      {[](Json& j) { j["animations"][0]["samplers"][0]["input"] = 99; }, "input"},
      {[](Json& j) { j["animations"][0]["samplers"][0].erase("output"); }, "output"},
      {[](Json& j) {
         j["nodes"][0]["skin"] = 0;
         j["skins"] = {{{"joints", {12, 0}}}};
       },
       "joint"},
  };
  for (const auto& fault : faults) {
    b.json = sound;
    fault.spoil(b.json);
    EXPECT_ERROR(error(), fault.said);
  }
}

TEST_F(Moved, AClipOfLengthZeroPlays) {
  channel(sampler({0}, {0, 3, 0}, "VEC3"), "translation");
  const Warnings quiet;
  for (const double seconds : {0.0, 0.5, 1e9})
    expect_near(b.load({.time_s = seconds}).primitives[0].vertices[0].position_m, {0, 3, 0});
}

// All of them stand for the same offset, of which the clip takes a ten-thousandth each.
TEST_F(Moved, TenThousandTargetsPlay) {
  constexpr std::size_t count = 10'000;
  const int offset = b.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  Json targets = Json::array();
  for (std::size_t t = 0; t < count; ++t) targets.push_back({{"POSITION", offset}});
  b.json["meshes"][0]["primitives"][0]["targets"] = targets;
  std::vector<float> weights(2 * count, 0);
  std::fill(weights.begin() + count, weights.end(), 1.0f / count);
  channel(sampler({0, 1}, weights, "SCALAR"), "weights");
  const Warnings quiet;
  EXPECT_NEAR(b.load({.time_s = 0.5}).primitives[0].vertices[0].position_m.z, 0.5, 1e-4);
}

TEST_F(Moved, ANodeWithAMatrixStands) {
  moves();
  b.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1};
  const Warnings warnings;
  expect_near(b.load({.time_s = 1.5}).primitives[0].vertices[0].position_m, {0, 0, 5});
  EXPECT_TRUE(warnings.any_with("has a matrix, so its animation is left out"));
}

// Before the first key as at it, at equal times the later one.
TEST_F(Moved, TimesMayBeNegativeAndEqual) {
  channel(sampler({-1, 0, 0, 1}, {0, 0, 0, 2, 0, 0, 4, 0, 0, 6, 0, 0}, "VEC3"), "translation");
  const Warnings quiet;
  const auto x_at = [&](double seconds) {
    return b.load({.time_s = seconds}).primitives[0].vertices[0].position_m.x;
  };
  EXPECT_NEAR(x_at(0), 4, 1e-6);
  EXPECT_NEAR(x_at(0.5), 5, 1e-6);
  EXPECT_NEAR(x_at(2), 6, 1e-6);
}

TEST_F(Moved, WhatIsNotAnimatedHereIsLeftOut) {
  moves();
  animation()["channels"].push_back({{"sampler", 0}, {"target", {{"path", "pointer"}}}});
  EXPECT_EQ(error(), "");
}

TEST_F(Moved, OneKeyIsAPose) {
  channel(sampler({0}, {1, 2, 3}, "VEC3"), "translation");
  const Warnings quiet;
  expect_near(b.load({.time_s = 7.0}).primitives[0].vertices[0].position_m, {1, 2, 3});
}

}  // namespace
}  // namespace dermis::scene::test
