// SPDX-License-Identifier: MIT
// Shadow maps are drawn when what they show has changed, and then alone: pictures are those of frames that
// draw all of them.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "api/asset_state.h"
#include "dermis/session.h"
#include "gpu/sessions/poses.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "support/rigs.h"
#include "support/scenes.h"

namespace dermis::tests {
namespace {

// A square of skin with a morph target, in the shadow of a sheet that hangs on a node before it.
Asset shaded_skin(float sheet_m) {
  scene::AssetData made = scene::plane(0.16, glm::dmat2(1), glm::dvec2(0), 8);
  add_sheet(made, 0.04f, sheet_m);
  made.primitives.back().placements = {{.world_from_mesh = glm::dmat4x3(1)}};
  made.rig = morphing(made, [](const glm::vec3& p) { return glm::vec3(p.x, p.y, 0.5f * p.x); });
  return Asset::State::make(scene::measured(std::move(made)));
}

SceneLight sun(double x, double z, double red = 1) {
  return {.light = {.colour = {red, 0.9, 0.8}, .direction = {x, -0.3, z}}};
}

// Shadow maps are smaller than any of these views needs, so that their sides are those of the settings.
RenderSettings settings_of(bool keep) {
  RenderSettings s = small_settings("texture-space", 48, 128);
  s.quality.shadow_size = 64;
  s.quality.keep_shadows = keep;
  s.camera.eye_m = {0.1, 0.05, 0.9};
  s.camera.target_m = {0.1, 0, 0};
  s.output.exposure_ev = 0;
  return s;
}

// Two sessions that draw the same scenes, of which one keeps its maps.
class Both {
 public:
  Scene scene;
  RenderSettings kept = settings_of(true), drawn = settings_of(false);

  void set(const std::function<void(RenderSettings&)>& change) {
    change(kept);
    change(drawn);
  }

  /// Draws a frame with each, compares them, and returns how many maps the one that keeps has drawn.
  std::uint64_t draw() {
    const Picture wanted = drawing_.picture(drawing_.draw(scene, drawn)),
                  found = keeping_.picture(keeping_.draw(scene, kept));
    expect_equal_bits(wanted, found);
    last_skin_pixels = wanted.statistics.skin_pixels;
    return found.statistics.shadow_maps_drawn;
  }

  std::uint64_t last_skin_pixels = 0;

 private:
  Session keeping_{renderer(), {.frames_in_flight = 2, .statistics = true}};
  Session drawing_{renderer(), {.frames_in_flight = 2, .statistics = true}};
};

TEST(KeptShadows, AreThoseOfFramesThatDrawAll) {
  Both both;
  Scene& scene = both.scene;
  const Asset asset = shaded_skin(0.03f), other = shaded_skin(0.02f);
  InstanceId first = scene.add({.asset = asset});
  const InstanceId second = scene.add({.asset = asset, .world_from_asset = turned(0.2, 0.2)});
  const LightId light = scene.add_light(sun(0.4, -0.7));

  const auto pose = [&](double weight, double sheet_m) {
    scene.set_pose(second, RigPose{.weights = {{.name = "0", .weight = weight}},
                                   .joints = {{.name = "1", .translation = std::array{sheet_m, 0.0, 0.0}}}});
  };
  pose(0, 0);

  constexpr std::uint64_t head = 1;  // depths and light that enters in one
  const auto expect_drawn = [&](const char* after, std::uint64_t maps) {
    SCOPED_TRACE(after);
    EXPECT_EQ(both.draw(), maps);
    EXPECT_GT(both.last_skin_pixels, 100u);
  };

  expect_drawn("the first frame", 2 * head);
  expect_drawn("nothing", 0);
  both.set([](RenderSettings& s) { s.camera.eye_m = {-0.2, 0.1, 0.8}; });
  expect_drawn("the camera has moved", 0);
  both.set([](RenderSettings& s) { s.output.exposure_ev = 0.5; });
  expect_drawn("another exposure", 0);
  both.set([](RenderSettings& s) { s.camera.eye_m = {0.5, 0.1, 0.7}; });
  expect_drawn("the other head is nearer", 0);
  both.set([](RenderSettings& s) { s.camera.eye_m = {0.1, 0.05, 0.9}; });

  scene.set_light(light, sun(0.4, -0.7, 3));
  expect_drawn("another colour of the light", 0);
  scene.set_light(light, sun(-0.3, -0.7));
  expect_drawn("the light has moved", 2 * head);
  scene.set_light(light, sun(-0.3, 0.7));
  expect_drawn("the light has gone behind", 2 * head);
  scene.set_light(light, sun(-0.3, -0.7));
  expect_drawn("the light is back", 2 * head);

  scene.set_transform(first, turned(-0.3, 0));
  expect_drawn("a head has turned", head);
  pose(0.8, 0);
  expect_drawn("skin has morphed", head);
  pose(0.8, 0.02);
  expect_drawn("a node has moved", head);
  expect_drawn("a pose that stays", 0);

  scene.set_tint(first, {0.4, 0.6, 0.9});
  expect_drawn("another tint", head);
  scene.set_mix(first, 1);
  expect_drawn("another mix", head);
  both.set([](RenderSettings& s) { s.lighting.white_albedo = true; });
  expect_drawn("white skin", 2 * head);
  both.set([](RenderSettings& s) { s.lighting.white_albedo = false; });
  expect_drawn("skin as it is", 2 * head);

  scene.set_visible(second, false);
  expect_drawn("a head is hidden", 0);
  scene.set_visible(second, true);
  expect_drawn("and shown", 0);
  scene.set_visible(second, false);
  both.draw();
  pose(0, -0.01);
  expect_drawn("and posed while it is hidden", 0);
  scene.set_visible(second, true);
  expect_drawn("and shown again", head);

  scene.remove(first);
  first = scene.add({.asset = other, .world_from_asset = turned(-0.3, 0)});
  expect_drawn("another asset, and with it a plan", 2 * head);
  both.set([](RenderSettings& s) { s.output.width = 56; });
  expect_drawn("another plan", 2 * head);
  scene.add_light(sun(0.1, -0.9));
  expect_drawn("a second light", 2 * 2 * head);
  expect_drawn("nothing", 0);
}

TEST(KeptShadows, AreDrawnAnewWhereTheirHeadNeedsOthers) {
  Both both;
  both.scene.add({.asset = shaded_skin(0.03f)});
  both.scene.add_light(sun(0.4, -0.7));
  both.set([](RenderSettings& s) { s.quality.shadow_size = 256; });
  EXPECT_EQ(both.draw(), 1u);
  both.set([](RenderSettings& s) { s.camera.eye_m = {0.1, 0.05, 1.8}; });
  EXPECT_EQ(both.draw(), 1u);
  EXPECT_EQ(both.draw(), 0u);
}

// Lit and blurred one after the other, each head has maps of its own all the same.
TEST(KeptShadows, OfHeadsThatAreLitInTurn) {
  Both both;
  const Asset asset = shaded_skin(0.03f);
  InstanceId last{};
  for (int i = 0; i < 5; ++i)
    last = both.scene.add({.asset = asset, .world_from_asset = turned(0.1 * i, 0.1 * i - 0.1)});
  both.scene.add_light(sun(0.4, -0.7));
  both.set([](RenderSettings& s) { s.quality.map_budget_mb = 2; });

  EXPECT_EQ(both.draw(), 5u);
  EXPECT_EQ(both.draw(), 0u);
  both.scene.set_transform(last, turned(0.4, 0.35));
  EXPECT_EQ(both.draw(), 1u);
  both.set([](RenderSettings& s) { s.camera.eye_m = {-0.4, 0.1, 0.8}; });
  EXPECT_EQ(both.draw(), 0u);
}

// Where maps of all heads take too much, heads that are lit in turn share them.
TEST(KeptShadows, ShareWhatIsTooMuch) {
  Both both;
  const Asset asset = shaded_skin(0.03f);
  for (int i = 0; i < 4; ++i)
    both.scene.add({.asset = asset, .world_from_asset = turned(0.1 * i, 0.1 * i - 0.1)});
  both.scene.add_light(sun(0.4, -0.7));
  both.set([](RenderSettings& s) {
    s.quality.map_budget_mb = 2;
    s.quality.shadow_size = 6144;
  });

  for (int i = 0; i < 2; ++i) EXPECT_EQ(both.draw(), 4u);
}

// An exposure is chosen by frames with white skin, which lets other light in: here through a small ball.
TEST(KeptShadows, DoNotOutlastTheFramesThatChooseAnExposure) {
  Scene scene = sphere(0.004);
  scene.add_light(sun(0.2, 0.9));
  scene.set_tint(scene.instances().front(), {0.3, 0.2, 0.1});
  RenderSettings kept = settings_of(true), drawn = settings_of(false);
  for (RenderSettings* s : {&kept, &drawn}) {
    s->camera = {.distance = 3};
    s->skin.mix = 1;
    s->output.exposure_ev = std::nullopt;
  }
  expect_equal_bits(renderer().render(scene, drawn), renderer().render(scene, kept));
}

// Of the frames that are timed, too, the first alone draws them. What does not last is overwritten between
// them.
TEST(KeptShadows, OfAPreparedFrameAreDrawnOnce) {
  Renderer poisoned(Renderer::Options{.poison = true});
  Scene scene(shaded_skin(0.03f));
  scene.add_light(sun(0.4, -0.7));
  PreparedFrame frame = poisoned.prepare(scene, settings_of(true));
  const Picture first = frame.picture();
  EXPECT_EQ(first.statistics.shadow_maps_drawn, 1u);
  frame.draw();
  frame.draw();
  expect_equal_bits(first, frame.picture());

  frame.set(settings_of(false));
  expect_equal_bits(first, frame.picture());
}

}  // namespace
}  // namespace dermis::tests
