// SPDX-License-Identifier: MIT
// Skin that is shaded as entries of pixels and composed into the targets of a host.
#include <fmt/format.h>

#include "frame.h"
#include "gpu/support/pictures.h"
#include "gpu/support/settings.h"
#include "render/techniques/technique.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

using EmbeddedEntries = WithHost;

Frame::Setup setup_of(const vulkan::PictureTargets& targets, VkExtent2D extent = {side, side}) {
  const vulkan::DepthTargets depth{targets.depth_format, targets.samples, targets.reversed_depth};
  return {.options = {.picture = targets, .depths = {depth}}, .extent = extent};
}

// The built-in head has eyes, teeth, and hair that is blended.
Scene turned_head() {
  Scene scene(Asset::built_in());
  scene.set_transform(scene.instances().front(),
                      {0.8, 0, 0.6, 0, 0, 1, 0, 0, -0.6, 0, 0.8, 0, 0.01, -0.02, -0.1, 1});
  return scene;
}

// Under blended hair, a picture says in alpha that skin is hidden; a host is told where skin is.
Pixels without_alpha(Pixels pixels) {
  for (std::size_t i = 3; i < pixels.rgba.size(); i += 4) pixels.rgba[i] = 0;
  return pixels;
}

class EmbeddedEntriesBySamples : public WithHost, public testing::WithParamInterface<std::uint32_t> {};

TEST_P(EmbeddedEntriesBySamples, EqualsTheRenderersPicture) {
  Frame frame(setup_of({.samples = GetParam()}));
  frame.frames->update(lit_ball(), frame_settings(GetParam()));
  frame.draw();
  const Pixels wanted = rendered(lit_ball(), frame_settings(GetParam()));
  if (GetParam() == 1) {
    EXPECT_EQ(frame.colour().rgba, wanted.rgba);
  } else {
    EXPECT_LE(largest_difference(frame.colour(), wanted), 2 * half_rounding)
        << "as the host's resolve rounds";
  }
}

// Not skin alone: all that is drawn, and what blended hair does to skin.
TEST_P(EmbeddedEntriesBySamples, EqualsTheRenderersPictureOfAllParts) {
  Frame frame(setup_of({.samples = GetParam()}));
  frame.frames->update(turned_head(), frame_settings(GetParam()));
  frame.draw();
  const double psnr = psnr_of_all_db(without_alpha(frame.colour()),
                                     without_alpha(rendered(turned_head(), frame_settings(GetParam()))));
  std::printf("%u samples: PSNR %.1f dB\n", GetParam(), psnr);
  EXPECT_GE(psnr, 60);
}
INSTANTIATE_TEST_SUITE_P(Samples, EmbeddedEntriesBySamples, testing::Values(1u, 4u));

struct DepthKind {
  VkFormat format = VK_FORMAT_D32_SFLOAT;
  bool reversed = true;
};

class EmbeddedEntriesDepth : public WithHost, public testing::WithParamInterface<DepthKind> {};

// The host's pre-pass, in a part of its image. One pixel that differs is a hole in the skin.
TEST_P(EmbeddedEntriesDepth, IsThatOfAPrePassToTheBit) {
  constexpr VkExtent2D whole{side + 37, side + 21};
  constexpr VkRect2D area{{31, 13}, {side, side}};
  const Frame::Setup setup =
      setup_of({.depth_format = GetParam().format, .reversed_depth = GetParam().reversed}, whole);
  Frame plain(setup), with(setup);
  plain.frames->update(turned_head(), frame_settings());
  with.frames->update(turned_head(), frame_settings());

  plain.draw({}, area);
  with.draw(
      [&](VkCommandBuffer commands) {
        with.frames->record_depth(
            commands, vulkan::clip_from_world(front_camera(GetParam().reversed)),
            {.depth = with.depth_image.view, .extent = whole, .area = area, .cull = true});
      },
      area);
  EXPECT_EQ(with.depth_bytes(), plain.depth_bytes());
  EXPECT_EQ(with.colour().rgba, plain.colour().rgba);
}
INSTANTIATE_TEST_SUITE_P(Kinds, EmbeddedEntriesDepth,
                         testing::Values(DepthKind{}, DepthKind{.reversed = false},
                                         DepthKind{.format = VK_FORMAT_D16_UNORM}));

// A view of one place is that of another, moved; the rest of the image stays as the host had it.
TEST_F(EmbeddedEntries, APartOfAnImageHoldsThePicture) {
  constexpr std::uint32_t border = 16;
  constexpr VkExtent2D whole{side + 3 * border, side + 2 * border};
  constexpr VkRect2D area{{2 * border, border}, {side, side}};
  for (const std::uint32_t samples : {1u, 4u}) {
    Frame frame(setup_of({.samples = samples}, whole));
    frame.frames->update(lit_ball(), frame_settings(samples));
    frame.draw(
        [&](VkCommandBuffer commands) {
          frame.host.clear(commands, &frame.colour_image, {3, 3, 3, 3}, nullptr, 0, {{0, 0}, whole});
          frame.host.clear(commands, &frame.colour_image, {0, 0, 0, 0}, nullptr, 0, area);
        },
        area);

    const Pixels found = frame.colour();
    for (std::uint32_t y = 0; y < whole.height; ++y)
      for (std::uint32_t x = 0; x < whole.width; ++x)
        for (std::size_t c = 0; c < 4 && !contains(area, x, y); ++c)
          ASSERT_EQ(found.at(x, y)[c], 3) << x << ", " << y;

    const Pixels wanted = rendered(lit_ball(), frame_settings(samples));
    // Corners of triangles round elsewhere: at the rim, samples move from one surface to another.
    EXPECT_GE(psnr_of_all_db(part_of(found, area), wanted), 60) << samples << " samples";
    // On skin alone a value may be the next half float: one step.
    if (samples == 1) { EXPECT_LE(largest_difference(part_of(found, area), wanted), 2 * half_rounding); }
  }
}

struct WayToShade {
  std::string technique;
  ScreenKernel kernel = ScreenKernel::profile;
};

std::vector<WayToShade> all_ways() {
  std::vector<WayToShade> ways;
  for (const std::string& technique : other_than_published()) ways.push_back({technique});
  for (const std::string technique : {"separable", "screen-gaussians"})
    ways.push_back({technique, ScreenKernel::published});
  return ways;
}

// In a part of larger targets, after a frame that filled them, of which nothing may be left.
TEST_F(EmbeddedEntries, EveryTechniqueDrawsItsPicture) {
  constexpr VkExtent2D whole{side + 37, side + 21};
  const Scene scene = turned_head();
  Frame frame(setup_of({.samples = 4}, whole));
  for (const WayToShade& way : all_ways()) {
    SCOPED_TRACE(way.technique);
    const VkRect2D area{{31, 14}, {side, side}};
    RenderSettings settings = frame_settings(4);
    settings.technique = way.technique;
    settings.quality.kernel = way.kernel;
    frame.frames->update(scene, settings);
    frame.draw({}, area);
    const std::vector<float> first = frame.colour().rgba;
    frame.draw({}, {{0, 0}, whole});
    frame.draw({}, area);
    EXPECT_EQ(frame.colour().rgba, first);

    const Pixels found = part_of(frame.colour(), area);
    const double psnr = psnr_db(found, rendered(scene, settings));
    std::printf("%s: PSNR %.1f dB\n", way.technique.c_str(), psnr);
    EXPECT_GE(psnr, 60);
  }
}

// Blurs of the picture read nothing beside the part that no pass of theirs has written, wherever it begins,
// and where the head goes on beyond it.
TEST_F(EmbeddedEntries, BlursReadNothingBesideTheirPartOfAnImage) {
  constexpr VkExtent2D whole{side + 37, side + 21};
  Scene near(Asset::built_in());
  near.set_transform(near.instances().front(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0.1, 1});
  for (const WayToShade& way : all_ways()) {
    if (!techniques::find_technique(way.technique).screen_space) continue;
    Frame::Setup setup = setup_of({}, whole);
    Frame clean(setup);
    setup.poisoned = true;
    Frame poisoned(setup);
    RenderSettings settings = frame_settings();
    settings.technique = way.technique;
    settings.quality.kernel = way.kernel;

    for (const Scene& scene : {turned_head(), near})
      for (const VkOffset2D low : {VkOffset2D{31, 13}, VkOffset2D{0, 0}}) {
        SCOPED_TRACE(fmt::format("{}, from {}, {}", way.technique, low.x, low.y));
        const VkRect2D area{low, {side, side}};
        for (Frame* frame : {&clean, &poisoned}) {
          frame->frames->update(scene, settings);
          frame->draw({}, area);
        }
        EXPECT_EQ(part_of(poisoned.colour(), area).rgba, part_of(clean.colour(), area).rgba);
      }
  }
}

// Something of the host's stands in front of the left half, at the near plane.
TEST_F(EmbeddedEntries, HeadsHideBehindWhatTheHostHasDrawn) {
  Frame frame(setup_of({.samples = 4}));
  const auto wall = [&](VkCommandBuffer commands) {
    frame.host.clear(commands, &frame.colour_image, {7, 7, 7, 0}, &frame.depth_image, 1,
                     {{0, 0}, {side / 2, side}});
  };
  frame.frames->update(turned_head(), frame_settings(4));
  frame.draw();
  const Pixels free = frame.colour();
  frame.draw(wall);
  const Pixels found = frame.colour();
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      for (std::size_t c = 0; c < 4; ++c)
        ASSERT_EQ(found.at(x, y)[c], x >= side / 2 ? free.at(x, y)[c] : c < 3 ? 7 : 0) << x << ", " << y;
}

// Heads that do not fit into light maps at once: their blended hair is drawn before the next ones are shaded,
// or, where all skin is shaded first, with their shadow maps again.
TEST_F(EmbeddedEntries, HeadsInBatchesEqualTheRenderersPicture) {
  Scene scene(Asset::built_in());
  const Asset asset = scene.instance(scene.instances().front()).asset;
  for (int i = 0; i < 4; ++i) {
    const InstanceId id = i == 0 ? scene.instances().front() : scene.add({.asset = asset});
    scene.set_transform(id, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.06 * i - 0.09, 0, -0.12 * i, 1});
  }
  for (const auto& [technique, keeps] :
       {std::pair<std::string, bool>{"texture-space", true}, {"lambert", true}, {"separable", false}}) {
    RenderSettings settings = frame_settings(4);
    settings.technique = technique;
    settings.quality.map_budget_mb = 7;
    settings.quality.keep_shadows = keeps;
    Frame frame(setup_of({.samples = 4}));
    frame.frames->update(scene, settings);
    frame.draw();
    const double psnr =
        psnr_of_all_db(without_alpha(frame.colour()), without_alpha(rendered(scene, settings)));
    std::printf("%s: PSNR %.1f dB\n", technique.c_str(), psnr);
    EXPECT_GE(psnr, 60);
  }
}

TEST_F(EmbeddedEntries, ASteadyFrameAsksTheDeviceForNothing) {
  Frame frame(setup_of({.samples = 4}));
  Scene scene = lit_ball();
  RenderSettings settings = frame_settings(4);
  DeviceCounters before;
  for (int i = 0; i < 10; ++i) {
    if (i == 2) before = frame.renderer->counters();
    scene.set_transform(scene.instances().front(),
                        {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.001 * i, 0, -0.02 * i, 1});
    settings.output.exposure_ev = 0.1 * i;
    frame.frames->update(scene, settings);
    frame.draw({}, {{i, 2 * i}, {side - std::uint32_t(2 * i), side - std::uint32_t(3 * i)}});
  }
  const DeviceCounters after = frame.renderer->counters();
  EXPECT_EQ(after.allocations, before.allocations);
  EXPECT_EQ(after.images, before.images);
  EXPECT_EQ(after.pipelines, before.pipelines);
  EXPECT_EQ(after.submissions, before.submissions);
  EXPECT_EQ(after.waits, before.waits);
}

TEST_F(EmbeddedEntries, AnImageThatIsTooLargeIsRefused) {
  Frame frame(setup_of({}));
  frame.frames->update(lit_ball(), frame_settings());
  frame.draw();
  const std::vector<float> before = frame.colour().rgba;
  frame.host.run([&](VkCommandBuffer commands) {
    vulkan::View view = frame.view();
    view.extent = {side, side + 1};
    const std::string said = thrown<InputError>(
        [&] { frame.frames->record(commands, std::span(&view, 1), {.frame = 2, .finished = 1}); });
    EXPECT_NE(said.find("picture.largest"), std::string::npos) << said;
  });
  frame.draw();
  EXPECT_EQ(frame.colour().rgba, before);
}

}  // namespace
}  // namespace dermis::tests
