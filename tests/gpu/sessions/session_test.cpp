// SPDX-License-Identifier: MIT
// A session draws what Renderer::render() draws, and asks the device for nothing but a submission per frame.
#include "dermis/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "api/asset_state.h"
#include "gpu/sessions/poses.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

// Around the head, at the distance of the first frame.
RenderSettings orbit(RenderSettings settings, double share, double radius_m) {
  const double angle = 2 * std::numbers::pi * share;
  settings.camera.eye_m = {radius_m * std::sin(angle), 0.05 * std::sin(3 * angle),
                           radius_m * std::cos(angle)};
  settings.camera.target_m = {0, 0, 0};
  settings.output.exposure_ev = std::sin(angle);
  return settings;
}

Asset ball() { return Asset::State::make(scene::measured(scene::sphere(0.06))); }

SceneLight sun(double angle_rad) {
  return {.light = {.colour = {1, 0.9, 0.8}, .direction = {std::cos(angle_rad), -0.5, std::sin(angle_rad)}}};
}

std::string name_of_counters(const DeviceCounters& c) {
  return "allocations " + std::to_string(c.allocations) + ", buffers " + std::to_string(c.buffers) +
         ", images " + std::to_string(c.images) + ", pipelines " + std::to_string(c.pipelines) +
         ", idle waits " + std::to_string(c.idle_waits);
}

// Camera, exposure, pose and light change in every frame. From the fourth on, no allocation, no pipeline, no
// wait for all that was submitted, one submission per frame, and memory stays as it is.
void expect_steady(const Scene& at_first, InstanceId turning, const RenderSettings& settings, int frames,
                   double radius_m, bool labels = false) {
  Scene scene = at_first;
  const LightId light = scene.lights().front();
  Session session(renderer(),
                  {.frames_in_flight = 2, .wanted = labels ? Outputs::all() : Outputs::picture()});
  DeviceCounters before;
  Ticket last{};

  for (int i = 0; i < frames; ++i) {
    if (i == 3) before = renderer().counters();
    const double share = static_cast<double>(i) / frames;
    scene.set_transform(turning, turned(0.3 * i, 0.01 * std::sin(i)));
    scene.set_light(light, sun(0.1 * i));
    const Ticket ticket = session.draw(scene, orbit(settings, share, radius_m));
    // To ask for the last frame is to wait for all that was submitted.
    if (labels && i > 0) { EXPECT_EQ(session.results(last).width, settings.output.width); }
    last = ticket;
  }

  const DeviceCounters after = renderer().counters();
  EXPECT_EQ(name_of_counters(after), name_of_counters(before));
  EXPECT_EQ(after.submissions - before.submissions, static_cast<std::uint64_t>(frames - 3));
}

TEST(Sessions, ASteadyFrameIsOneSubmission) {
  Scene scene;
  const InstanceId head = scene.add({.asset = Asset::built_in()});
  scene.add({.asset = ball(), .world_from_asset = turned(0, 0.2), .tint = {0.5, 0.4, 0.3}});
  scene.add_light(sun(0));
  expect_steady(scene, head, small_settings("texture-space", 64, 128), 40, 0.8);
}

TEST(Sessions, AndSoWithLabels) {
  Scene scene;
  const InstanceId head = scene.add({.asset = Asset::built_in()});
  scene.add({.asset = ball(), .world_from_asset = turned(0, 0.2)});
  scene.add_light(sun(0));
  expect_steady(scene, head, small_settings("texture-space", 64, 128), 12, 0.8, true);
}

// The distance to the nearest point changes with the angle, and with it the size of the light maps.
TEST(Sessions, AndSoWhileTheSizeOfTheMapsChanges) {
  Scene scene;
  const InstanceId head = scene.add({.asset = Asset::built_in()});
  scene.add_light(sun(0));
  RenderSettings s = small_settings("texture-space", 64, 256);
  s.quality.d_ref = 3;
  expect_steady(scene, head, s, 24, 1.2);
}

// From all terms on the map to none and back: the plan and its memory stay, and each picture is the
// renderer's.
TEST(Sessions, AndSoFromNearToFarAndBack) {
  Scene scene;
  const InstanceId head = scene.add({.asset = Asset::built_in()});
  scene.add({.asset = ball(), .world_from_asset = turned(0, 0.2)});
  scene.add_light(sun(0));
  RenderSettings s = orbit(small_settings("texture-space", 48, 256), 0, 0.8);
  s.quality.d_ref = 3;

  Session session(renderer(), {.frames_in_flight = 2, .statistics = true});
  DeviceCounters before;
  std::vector<int> terms;
  Ticket last{};
  int frame = 0;
  for (const double z_m : {0.0, 0.0, 0.0, 0.0, -0.5, -1.0, -2.0, -40.0, -40.0, -1.0, 0.0, -40.0, 0.2, 0.2}) {
    if (frame++ == 3) before = renderer().counters();
    scene.set_transform(head, moved({0, 0, z_m}));
    const Ticket ticket = session.draw(scene, s);
    // To ask for the last frame is to wait for all that was submitted.
    if (frame > 1) {
      const Statistics statistics = session.picture(last).statistics;
      terms.push_back(statistics.mapped_terms.front());
      EXPECT_EQ(statistics.unshaded_reads, 0u);
    }
    last = ticket;
  }
  EXPECT_EQ(name_of_counters(renderer().counters()), name_of_counters(before));
  EXPECT_EQ(terms.front(), 2);
  EXPECT_EQ(terms.back(), 2);
  EXPECT_EQ(std::count(terms.begin(), terms.end(), 0), 4);
  EXPECT_GT(std::count_if(terms.begin(), terms.end(), [](int count) { return count == 1; }), 0);

  // Again, against pictures of each alone.
  for (const double z_m : {-40.0, -0.5, 0.0, -1.0, -2.0}) {
    SCOPED_TRACE(z_m);
    scene.set_transform(head, moved({0, 0, z_m}));
    const Ticket ticket = session.draw(scene, s);
    expect_same_picture(renderer().render(scene, s), session.picture(ticket));
  }
}

using ScanSessions = WithScan;

// bench/sessions does so for 300 frames of 480 x 540 pixels.
TEST_F(ScanSessions, AreSteadyToo) {
  Scene scene = scan();
  if (scene.lights().empty()) scene.add_light(sun(0));
  RenderSettings s = small_settings("texture-space", 64, 512);
  expect_steady(scene, scene.instances().front(), s, 30, 1.2);
}

TEST(Sessions, DrawWhatTheRendererDraws) {
  Scene scene;
  const InstanceId head = scene.add({.asset = Asset::built_in()});
  scene.add_light(sun(0));
  RenderSettings s = small_settings("texture-space", 64, 128);
  s.lighting.environment = "studio";

  Session session(renderer(), {.frames_in_flight = 3, .statistics = true});
  std::vector<Scene> scenes;
  std::vector<RenderSettings> settings;
  std::vector<Ticket> tickets;
  std::vector<Picture> pictures;
  for (int i = 0; i < 6; ++i) {
    scene.set_transform(head, turned(0.2 * i, 0.01 * i));
    scenes.push_back(scene);
    settings.push_back(orbit(s, i / 6.0, 0.8));
    tickets.push_back(session.draw(scene, settings.back()));
    // Two frames later, so that three are on their way.
    if (i >= 2) pictures.push_back(session.picture(tickets[static_cast<std::size_t>(i - 2)]));
  }
  pictures.push_back(session.picture(tickets[4]));
  pictures.push_back(session.picture(tickets[5]));
  EXPECT_TRUE(session.is_ready(tickets[5]));

  for (std::size_t i = 0; i < pictures.size(); ++i) {
    SCOPED_TRACE(i);
    const Picture alone = renderer().render(scenes[i], settings[i]);
    expect_equal_bits(alone, pictures[i]);
    EXPECT_EQ(pictures[i].statistics.skin_pixels, alone.statistics.skin_pixels);
    EXPECT_EQ(pictures[i].statistics.irradiance_texels, alone.statistics.irradiance_texels);
  }
}

// A change of the plan ends the frames before it, whose pictures stay.
TEST(Sessions, GoOnAfterAChangeOfThePlan) {
  Scene scene;
  scene.add({.asset = ball()});
  scene.add_light(sun(0));
  RenderSettings s = orbit(small_settings("texture-space", 48, 128), 0, 0.4);
  Session session(renderer());
  const Ticket small = session.draw(scene, s);

  RenderSettings larger = s;
  larger.output.width = 96;
  scene.add({.asset = ball(), .world_from_asset = turned(0, 0.1)});
  const Ticket large = session.draw(scene, larger);
  EXPECT_EQ(session.picture(small).width, 48);
  EXPECT_EQ(session.picture(large).width, 96);
  EXPECT_EQ(session.picture(large).statistics.heads, 2);
  expect_equal_bits(renderer().render(scene, larger), session.picture(large));
}

TEST(Sessions, RefuseWhatTheyCannotDo) {
  Scene scene;
  RenderSettings s = orbit(small_settings("texture-space", 48, 128), 0, 0.4);
  Session session(renderer());
  const auto refused = [&](const RenderSettings& settings) {
    return thrown<InputError>([&] { session.draw(scene, settings); });
  };
  EXPECT_EQ(refused(s), "scene of 0 instances: has no instances: there is nothing to see");

  scene.add({.asset = ball()});
  const Ticket ticket = session.draw(scene, s);
  RenderSettings automatic = s;
  automatic.output.exposure_ev.reset();
  EXPECT_NE(refused(automatic).find("output.exposure_ev"), std::string::npos);
  RenderSettings map = s;
  map.output.show = "irradiance";
  EXPECT_NE(refused(map).find("output.show must be 'picture'"), std::string::npos);
  RenderSettings huge = s;
  huge.output.width = 1'000'000'000;
  EXPECT_NE(refused(huge).find("output.width"), std::string::npos);
  EXPECT_EQ(thrown<InputError>([&] { session.draw(scene, s, {}); }),
            "a session draws one view per frame, got 0");
  EXPECT_EQ(thrown<InputError>([&] { Session(renderer(), {.frames_in_flight = 0}); }),
            "frames_in_flight must be 1 to 3, got 0");

  // It goes on as before.
  EXPECT_EQ(session.picture(ticket).width, 48);
  session.draw(scene, s);
  session.draw(scene, s);
  EXPECT_EQ(thrown<InputError>([&] { session.picture(ticket); }),
            "ticket 1 is not of the last 2 frames of this session");
  EXPECT_EQ(thrown<InputError>([&] { session.is_ready(Ticket{99}); }),
            "ticket 99 is not of the last 2 frames of this session");
}

}  // namespace
}  // namespace dermis::tests
