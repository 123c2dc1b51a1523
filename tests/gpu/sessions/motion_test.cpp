// SPDX-License-Identifier: MIT
// Labels of motion say where each point of a surface was in the frame before: by camera, instance, joints and
// morph targets together.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <string>
#include <vector>

#include "api/asset_state.h"
#include "dermis/session.h"
#include "gpu/sessions/poses.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "support/assets.h"
#include "support/log_lines.h"
#include "support/rigs.h"

namespace dermis::tests {
namespace {

constexpr int side = 96;

RenderSettings seen_from(const glm::dvec3& eye_m, int pixels = side) {
  RenderSettings s = small_settings("lambert", pixels, 64);
  s.camera.eye_m = {eye_m.x, eye_m.y, eye_m.z};
  s.camera.target_m = {0, 0, 0};
  s.camera.fov_deg = 20;
  s.output.exposure_ev = 0;
  return s;
}

/// Pixels from the upper left corner of a picture by seen_from().
glm::dvec2 pixel_of(const glm::dvec3& eye_m, const glm::dvec3& position_m) {
  const glm::dmat4 camera = glm::lookAt(eye_m, glm::dvec3(0), glm::dvec3(0, 1, 0));
  const glm::dmat4 clip = glm::perspectiveRH_ZO(glm::radians(20.0), 1.0, 0.01, 10.0);
  const glm::dvec4 p = clip * camera * glm::dvec4(position_m, 1);
  return {(p.x / p.w + 1) / 2 * side, (1 - p.y / p.w) / 2 * side};
}

glm::dvec2 motion_at(const Results& l, std::size_t i) { return {l.motion_px[2 * i], l.motion_px[2 * i + 1]}; }

bool all_still(const Results& l) {
  for (const float value : l.motion_px)
    if (value != 0) return false;
  return true;
}

std::array<double, 16> flat(const glm::dmat4& m) {
  std::array<double, 16> values{};
  for (int i = 0; i < 16; ++i) values[static_cast<std::size_t>(i)] = m[i / 4][i % 4];
  return values;
}

/// What stands where in a frame of the scene below.
struct Moment {
  glm::dvec3 eye_m{0, 0, 0.7};
  glm::dmat4 world_from_asset{1};
  double weight = 0;      ///< of the morph target of the square
  glm::dvec3 sheet_m{0};  ///< where the sheet's own node stands
  bool posed = true;
};

constexpr double square_m = 0.16;

/// At weight 1 a point of the square is there: stretched, sheared and bent, along straight lines of uv.
glm::dvec3 morphed(const glm::dvec3& p) { return {1.3 * p.x + 0.4 * p.y, 0.9 * p.y, 0.5 * p.x}; }

/// A square of skin with a morph target, and before it a sheet that hangs on a node.
Asset square_and_sheet() {
  scene::AssetData made = scene::plane(square_m, glm::dmat2(1), glm::dvec2(0), 8);
  add_sheet(made, 0.04f, 0.03f);
  made.primitives.back().placements = {{.world_from_mesh = glm::dmat4x3(1)},
                                       {.world_from_mesh = glm::dmat4x3(1)}};
  made.rig = morphing(made, [](const glm::vec3& p) { return glm::vec3(morphed(p)); });
  return Asset::State::make(scene::measured(std::move(made)));
}

class Film {
 public:
  explicit Film(int frames_in_flight = 1)
      : session_(renderer(), {.frames_in_flight = frames_in_flight, .wanted = Outputs::all()}),
        id_(scene_.add({.asset = square_and_sheet()})) {}

  Ticket draw(const Moment& m) {
    scene_.set_transform(id_, flat(m.world_from_asset));
    scene_.set_pose(id_, {});
    if (m.posed) {
      const auto at = [](const glm::dvec3& p) { return std::array{p.x, p.y, p.z}; };
      scene_.set_pose(id_, RigPose{.weights = {{.name = "0", .weight = m.weight}},
                                   .joints = {{.name = "1", .translation = at(m.sheet_m)},
                                              {.name = "2", .translation = at(-m.sheet_m)}}});
    }
    return session_.draw(scene_, seen_from(m.eye_m));
  }
  Results labels(Ticket ticket) const { return session_.results(ticket); }
  Results next(const Moment& m) { return labels(draw(m)); }
  Scene& scene() { return scene_; }

 private:
  Scene scene_;
  Session session_;
  InstanceId id_;
};

/// Where the point that a pixel shows stands at that moment, in the world. Its coordinates name it.
glm::dvec3 place_of(const Results& l, std::size_t i, const Moment& m) {
  const glm::dvec3 p((l.uv[2 * i] - 0.5) * square_m, (0.5 - l.uv[2 * i + 1]) * square_m, 0);
  return m.world_from_asset * glm::dvec4(glm::mix(p, morphed(p), m.posed ? m.weight : 0), 1);
}

/// Each pixel of the square against the closed form; returns the largest motion.
double expect_motion(const Results& l, const Moment& before, const Moment& now) {
  std::size_t seen = 0;
  double largest = 0;
  for (std::size_t i = 0; i < l.instance.size(); ++i) {
    if (l.instance[i] != 1 || l.material[i] != 1) continue;
    ++seen;
    const glm::dvec2 at = pixel_of(now.eye_m, place_of(l, i, now));
    const auto x = static_cast<double>(i % side), y = static_cast<double>(i / side);
    EXPECT_LT(glm::distance(at, glm::dvec2(x + 0.5, y + 0.5)), 5e-3) << i;
    const glm::dvec2 expected = at - pixel_of(before.eye_m, place_of(l, i, before));
    EXPECT_LT(glm::distance(motion_at(l, i), expected), 5e-3) << i;
    largest = std::max(largest, glm::length(expected));
  }
  EXPECT_GT(seen, 500u);
  return largest;
}

const glm::dmat4 turned_and_moved =
    glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(0.01, -0.02, 0.03)), 0.4, glm::dvec3(0.3, 0.8, 0.1));

TEST(Motion, IsOfCameraInstanceAndPoseTogether) {
  Film film;
  EXPECT_TRUE(all_still(film.next({}))) << "of the first frame";
  EXPECT_TRUE(all_still(film.next({}))) << "of what stands still";

  const std::vector<Moment> moments{
      {.eye_m = {0.2, 0.05, 0.6}},
      {.eye_m = {0.2, 0.05, 0.6}, .world_from_asset = turned_and_moved},
      {.eye_m = {0.2, 0.05, 0.6}, .world_from_asset = turned_and_moved, .weight = 1},
      {.eye_m = {0, -0.1, 0.8}, .weight = 0.25},
  };
  Moment before;
  for (const Moment& now : moments) {
    EXPECT_GT(expect_motion(film.next(now), before, now), 3);
    EXPECT_TRUE(all_still(film.next(now))) << "once it stands";
    before = now;
  }
}

TEST(Motion, OfAFirstPoseIsFromRest) {
  Film film;
  const Moment rest{.posed = false}, now{.weight = 1};
  film.next(rest);
  EXPECT_GT(expect_motion(film.next(now), rest, now), 3);
}

// The sheet hangs on two nodes, one for each of its copies, which move apart.
TEST(Motion, OfWhatHangsOnANodeIsThatOfTheNode) {
  Film film;
  film.next({});
  const Moment now{.sheet_m = {0.004, 0.003, 0.01}};
  const Results l = film.next(now);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < l.instance.size(); ++i) {
    if (l.material[i] != 2) {
      EXPECT_EQ(motion_at(l, i), glm::dvec2(0)) << "the square stands still";
      continue;
    }
    // The middle of the pixel shows a point of one of the copies: depth says of which.
    const bool first = 0.7 - l.depth_m[i] > 0.03;
    const double depth_m = l.depth_m[i];
    const double half_m = depth_m * std::tan(glm::radians(10.0));
    const glm::dvec3 point((2 * (static_cast<double>(i % side) + 0.5) / side - 1) * half_m,
                           (1 - 2 * (static_cast<double>(i / side) + 0.5) / side) * half_m, 0.7 - depth_m);
    const glm::dvec3 then = point - (first ? now.sheet_m : -now.sheet_m);
    const glm::dvec2 expected = pixel_of(now.eye_m, point) - pixel_of(now.eye_m, then);
    EXPECT_LT(glm::distance(motion_at(l, i), expected), 5e-3) << i;
    ++seen;
  }
  EXPECT_GT(seen, 300u);
}

TEST(Motion, IsSinceTheFrameBeforeWithThreeInFlight) {
  Film film(3);
  std::vector<Moment> moments;
  std::vector<Ticket> tickets;
  for (int i = 0; i < 6; ++i) {
    moments.push_back({.eye_m = {0.05 * i, 0, 0.7}, .weight = 0.2 * i * (i % 2)});
    tickets.push_back(film.draw(moments.back()));
    if (i < 2) continue;
    const auto done = static_cast<std::size_t>(i - 1);
    EXPECT_GT(expect_motion(film.labels(tickets[done]), moments[done - 1], moments[done]), 1) << i;
  }
}

TEST(Motion, OfWhatWasNotThereIsNone) {
  Film film;
  film.next({});
  const InstanceId ball = film.scene().add({.asset = Asset::State::make(scene::measured(scene::sphere(0.02))),
                                            .world_from_asset = moved({0, 0, 0.2})});
  const Moment now{.eye_m = {0.1, 0, 0.7}};
  const Results l = film.next(now);
  std::size_t of_ball = 0;
  for (std::size_t i = 0; i < l.instance.size(); ++i)
    if (l.instance[i] == 2) {
      ++of_ball;
      EXPECT_EQ(motion_at(l, i), glm::dvec2(0)) << "a new instance";
    }
  EXPECT_GT(of_ball, 50u);
  expect_motion(l, {}, now);

  // Numbers of instances shift, but not what they were.
  film.scene().remove(ball);
  expect_motion(film.next({}), now, {});
}

TEST(Motion, OfWhatLayBehindTheCameraIsInfinite) {
  Film film;
  film.next({.eye_m = {0, 0, 0.7}, .world_from_asset = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 1))});
  const Results l = film.next({});
  std::size_t seen = 0;
  for (std::size_t i = 0; i < l.instance.size(); ++i) {
    if (l.material[i] != 1) continue;
    ++seen;
    EXPECT_EQ(motion_at(l, i), glm::dvec2(std::numeric_limits<double>::infinity()));
  }
  EXPECT_GT(seen, 500u);
}

// A character that plays: where a pixel's point was in the frame before, that frame shows the same point.
TEST(Motion, OfACharacterLeadsToTheSamePoint) {
  const std::filesystem::path file = asset_cache() / "makehuman" / "mh-african-man-young.glb";
  if (const std::string missing = missing_asset({file}); !missing.empty()) GTEST_SKIP() << missing;
  const LogLines quiet;
  Scene scene;
  const InstanceId id = scene.add({.asset = Asset::load(file)});
  Session session(renderer(), {.frames_in_flight = 1, .wanted = Outputs::all()});
  RenderSettings s = seen_from({0.1, 0.35, 0.9}, 240);
  s.camera.target_m = {0, 0.3, 0.05};

  scene.pose(id, "performance", 1.2);
  const Results before = session.results(session.draw(scene, s));
  scene.pose(id, "performance", 1.4);
  const Results now = session.results(session.draw(scene, s));
  std::size_t moved = 0, same = 0;
  for (std::size_t i = 0; i < now.instance.size(); ++i) {
    const glm::dvec2 by = motion_at(now, i);
    if (now.region[i] == Results::no_region || glm::length(by) < 1) continue;
    const auto x = static_cast<int>(std::floor(static_cast<double>(i % 240) + 0.5 - by.x));
    const auto y = static_cast<int>(std::floor(static_cast<double>(i / 240) + 0.5 - by.y));
    const auto at = static_cast<std::size_t>(y * 240 + x);
    ++moved;
    const double apart = std::hypot(double{now.uv[2 * i]} - double{before.uv[2 * at]},
                                    double{now.uv[2 * i + 1]} - double{before.uv[2 * at + 1]});
    same += before.material[at] == now.material[i] && apart < 0.004;  // a pixel is 0.003 wide there
  }
  std::printf("%zu pixels moved by one or more, %zu lead to the same point\n", moved, same);
  EXPECT_GT(moved, 2000u);
  EXPECT_GT(static_cast<double>(same), 0.97 * static_cast<double>(moved)) << "but where something hid it";
}

}  // namespace
}  // namespace dermis::tests
