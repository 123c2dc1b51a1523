// SPDX-License-Identifier: MIT
// Way (iv): the light is the host's.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "frame.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/scenes.h"

namespace dermis::tests {
namespace {

using EmbeddedLight = WithHost;

// Light from straight above, which shines along -y.
Scene lit_from_above() {
  Scene scene{Asset::built_in()};
  for (const LightId light : scene.lights()) scene.remove_light(light);
  scene.add_light({.light = {.colour = {2, 2, 2}, .direction = {0.2, -1, -0.3}}});
  return scene;
}

// An orthographic view along the light of a scene, 0.5 m wide and deep, forward depth, clip y down.
std::array<double, 16> light_view(const Scene& scene) {
  const std::array<double, 3> d = scene.light(scene.lights().front()).light.direction;
  const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const std::array<double, 3> z{d[0] / length, d[1] / length, d[2] / length};
  const double flat = std::sqrt(z[0] * z[0] + z[2] * z[2]);
  const std::array<double, 3> x{z[2] / flat, 0, -z[0] / flat};
  const std::array<double, 3> y{z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2],
                                z[0] * x[1] - z[1] * x[0]};
  std::array<double, 16> m{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    m[4 * axis + 0] = x[axis] / 0.25;
    m[4 * axis + 1] = y[axis] / 0.25;
    m[4 * axis + 2] = z[axis] / 0.5;
  }
  m[14] = 0.5;
  m[15] = 1;
  return m;
}

constexpr std::uint32_t shadow_side = 512;

// How the host draws its shadow map.
struct Convention {
  bool reversed_depth = false, y_down = true;
};

std::array<double, 16> by_convention(std::array<double, 16> m, const Convention& convention) {
  for (std::size_t column = 0; column < 4; ++column) {
    if (!convention.y_down) m[4 * column + 1] = -m[4 * column + 1];
    if (convention.reversed_depth) m[4 * column + 2] = m[4 * column + 3] - m[4 * column + 2];
  }
  return m;
}

// The host's shadow map with the heads in it, and, if it wants, something before the light.
class HostShadow {
 public:
  HostShadow(Frame& frame, const Scene& scene, const Convention& convention = {})
      : frame_(&frame),
        convention_(convention),
        matrix_(by_convention(light_view(scene), convention)),
        map_(frame.host.image(VK_FORMAT_D32_SFLOAT, {shadow_side, shadow_side}, 1,
                              VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT)) {}

  vulkan::HostInputs inputs(const Scene& scene) const {
    return {.shadows = {{.light = scene.lights().front(),
                         .depth = map_.view,
                         .extent = {shadow_side, shadow_side},
                         .clip_from_world = matrix_,
                         .reversed_depth = convention_.reversed_depth,
                         .y_down = convention_.y_down}}};
  }
  void record(VkCommandBuffer commands, float cleared_to) {
    frame_->host.transition(commands, map_, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    frame_->host.clear(commands, nullptr, {}, &map_, cleared_to, {{0, 0}, {shadow_side, shadow_side}});
    frame_->frames->record_depth(commands, matrix_,
                                 {.targets = convention_.reversed_depth ? 1u : 0u,
                                  .depth = map_.view,
                                  .extent = {shadow_side, shadow_side},
                                  .y_down = convention_.y_down});
    frame_->host.transition(commands, map_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  }

 private:
  Frame* frame_;
  Convention convention_;
  std::array<double, 16> matrix_;
  HostImage map_;
};

Frame::Setup with_depths() {
  return {.options = {.picture = vulkan::PictureTargets{},
                      .depths = {vulkan::DepthTargets{.reversed_depth = false}, vulkan::DepthTargets{}}}};
}

TEST_F(EmbeddedLight, AShadowMapOfTheHostTakesThePlaceOfOurs) {
  const Scene scene = lit_from_above();
  RenderSettings settings = frame_settings();
  settings.quality.shadow_size = shadow_side;
  settings.lighting.ambient = 0;
  const Pixels wanted = rendered(scene, settings);
  for (const Convention& convention : {Convention{}, Convention{.reversed_depth = true},
                                       Convention{.y_down = false}, Convention{true, false}}) {
    Frame frame(with_depths());
    HostShadow shadow(frame, scene, convention);
    // Before the map is there, its heads must be.
    frame.frames->update(scene, settings, shadow.inputs(scene));
    frame.draw([&](VkCommandBuffer commands) { shadow.record(commands, convention.reversed_depth ? 0 : 1); });
    const double psnr = psnr_db(wanted, frame.colour());
    std::printf("near is %d, y %s: PSNR %.1f dB\n", convention.reversed_depth ? 1 : 0,
                convention.y_down ? "down" : "up", psnr);
    // Other texels, of 0.98 mm in place of 0.6.
    EXPECT_GT(psnr, 40);
  }
}

TEST_F(EmbeddedLight, WhatTheHostPutsBeforeALightDarkensTheHeads) {
  const Scene scene = lit_from_above();
  RenderSettings settings = frame_settings();
  settings.lighting.ambient = 0.2;
  Frame frame(with_depths());
  HostShadow shadow(frame, scene);
  frame.frames->update(scene, settings, shadow.inputs(scene));
  frame.draw([&](VkCommandBuffer commands) { shadow.record(commands, 1); });
  // What the host has drawn over its map since then holds.
  frame.draw([&](VkCommandBuffer commands) { shadow.record(commands, 0); });

  Scene dark = scene;
  dark.set_light(dark.lights().front(), {.light = {.colour = {0, 0, 0}, .direction = {0, -1, 0}}});
  EXPECT_LE(largest_difference(rendered(dark, settings), frame.colour()), 2 * half_rounding);
}

// The same irradiance from everywhere: pi times the radiance of uniform surroundings. Without reflections all
// of it enters.
TEST_F(EmbeddedLight, IrradianceOfTheHostTakesThePlaceOfLights) {
  Scene scene = sphere(0.07);
  RenderSettings settings = frame_settings();
  settings.lighting.specular = false;
  settings.lighting.rig_lights = 0;
  settings.lighting.ambient = 0.5;
  const Pixels wanted = rendered(scene, settings);

  Frame frame;
  std::size_t squares = 0;
  constexpr float e = 0.5f * static_cast<float>(std::numbers::pi);
  vulkan::HostInputs inputs;
  inputs.draw_irradiance = [&](VkCommandBuffer commands, const vulkan::IrradianceTarget& target) {
    const HostImage image{.view = target.view, .extent = target.extent};
    for (const vulkan::IrradianceSquare& square : target.squares) {
      EXPECT_EQ(square.record, frame.frames->record_of(square.instance, square.skin_mesh));
      frame.host.clear(commands, &image, {e, e, e, 1}, nullptr, 0, square.area);
      ++squares;
    }
  };
  frame.frames->update(scene, settings, inputs);
  frame.draw();
  EXPECT_EQ(squares, 1u);
  EXPECT_LE(largest_difference(wanted, frame.colour()), 2 * half_rounding);

  // What it does not draw is dark.
  inputs.draw_irradiance = [](VkCommandBuffer, const vulkan::IrradianceTarget&) {};
  frame.frames->update(scene, settings, inputs);
  frame.draw();
  const Pixels dark = frame.colour();
  EXPECT_EQ(*std::max_element(dark.at(side / 2, side / 2), dark.at(side / 2, side / 2) + 3), 0);
}

}  // namespace
}  // namespace dermis::tests
