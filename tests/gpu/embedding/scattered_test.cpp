// SPDX-License-Identifier: MIT
// Way (iii): the light of the terms that are mapped, and the weight of the rest, as shaders of a host read
// them.
#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "frame.h"
#include "gpu/cmd.h"
#include "gpu/device.h"
#include "gpu/pipelines.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "render/passes/bindings.h"

namespace dermis::test_embedding {
std::span<const std::uint32_t> find_shader(std::string_view name);
}

namespace dermis::tests {
namespace {

using EmbeddedScattered = WithHost;

constexpr std::uint32_t grid = 64;            // points per side, over all texture coordinates
constexpr double rounding = 2.0 / (1 << 10);  // of two half floats around 1

// As scattered.glsl has it.
struct Scattered {
  std::array<float, 3> light, rest;
};

std::array<double, 16> moved(const std::array<double, 3>& by_m) {
  return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, by_m[0], by_m[1], by_m[2], 1};
}

// Uniform light, and white skin that reflects nothing: where all of the light is there, it leaves as 1. All
// of the skin is lit, so that all that can be read may be.
RenderSettings furnace() {
  RenderSettings s = in_a_furnace(frame_settings());
  s.lighting.specular = s.quality.cull = s.quality.clip = false;
  return s;
}

// A scene in a frame of so many pixels per side, the eye at 0.4 m.
class Seen {
 public:
  explicit Seen(std::uint32_t pixels, Scene scene = sphere(0.07))
      : scene_(std::move(scene)),
        frame_({.options = {.picture = vulkan::PictureTargets{}, .scattered = true},
                .extent = {pixels, pixels}}) {}

  void draw(const RenderSettings& settings, const vulkan::HostInputs& inputs = {}) {
    frame_.frames->update(scene_, settings, inputs);
    frame_.draw();
  }
  const vulkan::Recorded& recorded() const { return frame_.recorded; }

  std::vector<Scattered> read(std::size_t number = 0) {
    gpu::Device device(frame_.host.vulkan());
    gpu::PipelineLibrary library(device, test_embedding::find_shader);
    const gpu::Pipeline& pipeline = library.compute("read_scattered.comp");
    const gpu::Texture light("light", {.array = true}, recorded().scattered);
    const gpu::Buffer records("records", recorded().records);
    std::vector<Scattered> found(std::size_t{grid} * grid);
    const gpu::Buffer out(
        device, "found",
        {.bytes = found.size() * sizeof(Scattered), .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});

    frame_.host.run([&](VkCommandBuffer commands) {
      gpu::Cmd cmd(device, commands);
      passes::Bindings()
          .add("dermis_light", gpu::SampledBinding{&light, library.sampler({})})
          .add("DermisRecords",
               gpu::BufferBinding{&records, recorded().records_offset, recorded().records_bytes})
          .add("Found", out)
          .bind(cmd, pipeline);
      cmd.push(pipeline, std::array{frame_.frames->record_of(scene_.instances()[number]), grid});
      cmd.dispatch_over(pipeline, grid, grid);
    });
    const std::vector<std::byte> bytes = gpu::read_back(device, out);
    std::memcpy(found.data(), bytes.data(), bytes.size());
    return found;
  }
  std::vector<Scattered> drawn(const RenderSettings& settings, double further_m = 0) {
    scene_.set_transform(scene_.instances().front(), moved({0, 0, -further_m}));
    draw(settings);
    return read();
  }

 private:
  Scene scene_;
  Frame frame_;
};

// Expects that all light is there, and returns the least rest of red.
double least_rest(const std::vector<Scattered>& found) {
  double least = 1;
  for (const Scattered& at : found) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(at.light[c] + at.rest[c], 1, rounding);
      EXPECT_GE(at.rest[c], -rounding);
    }
    least = std::min(least, double{at.rest[0]});
  }
  return least;
}

TEST_F(EmbeddedScattered, LightAndRestAreAllLightAtEachDistance) {
  Seen ball(384);  // pixels of half a millimetre, where it is near
  const auto least_at = [&](double further_m) { return least_rest(ball.drawn(furnace(), further_m)); };
  // The two widest terms are mapped, which are 44 % of red; then some of what enters for the others, too;
  // then the widest alone, and in part; then none, as pixels are wider than any spreads.
  const double near = least_at(0), further = least_at(0.8);
  EXPECT_NEAR(near, 0.56, 0.05);
  EXPECT_LT(further, near - 0.02);
  EXPECT_NEAR(least_at(1.6), 0.92, 0.05);
  EXPECT_EQ(least_at(40), 1);
}

TEST_F(EmbeddedScattered, ThereIsNoRestWhereAllTermsAreMapped) {
  RenderSettings settings = furnace();
  settings.quality.depth = false;
  EXPECT_NEAR(least_rest(Seen(side).drawn(settings)), 0, rounding);
}

TEST_F(EmbeddedScattered, LightThatLeavesWhereItEnteredIsRest) {
  const double rest = least_rest(Seen(384).drawn(
      with_profile(furnace(), "half",
                   {{.variance_mm2 = 0, .weight = {1, 1, 1}}, {.variance_mm2 = 4, .weight = {1, 1, 1}}})));
  EXPECT_NEAR(rest, 0.5, rounding);
}

// A head that is hidden, or outside of the picture, is the host's alone.
TEST_F(EmbeddedScattered, AllIsRestWhereAHeadIsNotLit) {
  for (const Scattered& at : Seen(side).drawn(furnace(), -2)) {
    EXPECT_EQ(at.light, (std::array<float, 3>{0, 0, 0}));
    EXPECT_EQ(at.rest, (std::array<float, 3>{1, 1, 1}));
  }
}

// Red, green and blue balls, of which a turn of the pool holds one. Half of their colour acts before the
// light spreads: what they hold is that of their own layer.
TEST_F(EmbeddedScattered, EachTurnOfThePoolHasItsOwnLight) {
  Scene balls = sphere(0.03);
  const InstanceId first = balls.instances().front();
  for (int i = 1; i < 3; ++i) balls.add({.asset = balls.instance(first).asset});
  for (int i = 0; i < 3; ++i) {
    const InstanceId id = balls.instances()[static_cast<std::size_t>(i)];
    balls.set_transform(id, moved({0.06 * i - 0.06, 0, 0}));
    std::array<double, 3> tint{0.1, 0.1, 0.1};
    tint[static_cast<std::size_t>(i)] = 1;
    balls.set_tint(id, tint);
  }

  Seen seen(384, balls);
  RenderSettings settings = furnace();
  settings.lighting.white_albedo = false;
  settings.quality.skip_unseen_heads = false;
  settings.quality.cull = settings.quality.depth = false;  // one head per turn
  seen.draw(settings);
  for (std::size_t number = 0; number < 3; ++number) {
    std::size_t lit = 0;
    for (const Scattered& at : seen.read(number)) {
      if (at.light[number] < 0.05f) continue;
      ++lit;
      for (std::size_t c = 0; c < 3; ++c) {
        if (c == number) continue;
        ASSERT_LT(at.light[c], 0.7f * at.light[number]) << number;
      }
    }
    EXPECT_GT(lit, std::size_t{grid} * grid / 4) << number;
  }
}

// A host that draws the light itself has lit what there is to light, also where that is nothing.
TEST_F(EmbeddedScattered, ThereIsNoRestWhereTheLightIsTheHosts) {
  Seen ball(side);
  ball.draw(furnace(), {.draw_irradiance = [](VkCommandBuffer, const vulkan::IrradianceTarget&) {}});
  for (const Scattered& at : ball.read()) {
    EXPECT_EQ(at.light, (std::array<float, 3>{0, 0, 0}));
    EXPECT_EQ(at.rest, (std::array<float, 3>{0, 0, 0}));
  }
}

TEST_F(EmbeddedScattered, OfASceneWithoutSkinThereIsNone) {
  scene::AssetData plain = scene::sphere(0.07);
  for (scene::Material& material : plain.materials) material.skin = false;
  Seen seen(side, wrap(plain));
  seen.draw(furnace());
  EXPECT_EQ(seen.recorded().scattered, VK_NULL_HANDLE);
}

}  // namespace
}  // namespace dermis::tests
