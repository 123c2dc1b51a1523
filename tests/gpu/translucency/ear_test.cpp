// SPDX-License-Identifier: MIT
// The scan's ear with the light behind it: as the reference has it, with all optimisations, and without a lit
// point that was not there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "dermis/reference.h"
#include "gpu/support/failure.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "gpu/translucency/slab.h"
#include "image/compare_flip.h"
#include "image/metrics.h"
#include "support/assets.h"

namespace dermis::tests {
namespace {

class Ear : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string missing = missing_scan(); !missing.empty()) GTEST_SKIP() << missing;
    static const Scene opened = Scene::load(scan_manifest("lee-perry-smith-backlit.gltf"));
    scan = &opened;
  }
  const Scene* scan = nullptr;
};

constexpr int side = 128;

RenderSettings ear_settings() {
  RenderSettings s;
  s.output.width = s.output.height = side;
  s.quality.map_size = 1024;
  s.quality.shadow_size = 2048;  // 0.3 mm per texel: the scan has shoulders
  s.camera.name = "ear";
  s.output.bloom = 0;
  return s;
}

// The front of the ear: a polygon inside its outline.
std::vector<std::uint8_t> ear_region() {
  static constexpr glm::dvec2 corners[] = {{0.25, 0.193}, {0.367, 0.163}, {0.467, 0.173}, {0.56, 0.227},
                                           {0.62, 0.333}, {0.627, 0.5},   {0.593, 0.65},  {0.5, 0.8},
                                           {0.367, 0.95}, {0.2, 0.967},   {0.15, 0.833},  {0.183, 0.567},
                                           {0.2, 0.333}};
  std::vector<std::uint8_t> mask(side * side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 p((x + 0.5) / side, (y + 0.5) / side);
      bool inside = false;
      for (std::size_t i = 0, j = std::size(corners) - 1; i < std::size(corners); j = i++) {
        const glm::dvec2 a = corners[i], b = corners[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
          inside = !inside;
      }
      mask[static_cast<std::size_t>(y * side + x)] = inside;
    }
  return mask;
}

TEST_F(Ear, GlowsAsTheReferenceDoes) {
  RenderSettings s = ear_settings();
  const Picture truth = render_reference(*scan, s, {.samples = 256}).picture;
  const Picture on = renderer().render(*scan, s);
  s.skin.translucency = false;
  const Picture off = renderer().render(*scan, s);

  const std::vector<std::uint8_t> region = ear_region();
  const double with = image::mean_flip(shown(truth), shown(on), region),
               without = image::mean_flip(shown(truth), shown(off), region);
  std::printf("FLIP over the ear: %.4f with, %.4f without, ratio %.3f\n", with, without, with / without);
  EXPECT_LE(with, 0.5 * without) << write_failure(linear(truth), linear(on));

  std::array<double, 3> light[3] = {};  // over the region: truth, with, without
  for (std::size_t i = 0; i < region.size(); ++i)
    if (region[i])
      for (std::size_t c = 0; c < 3; ++c) {
        light[0][c] += double{truth.linear_rgba[4 * i + c]};
        light[1][c] += double{on.linear_rgba[4 * i + c]};
        light[2][c] += double{off.linear_rgba[4 * i + c]};
      }

  const double glow = light[0][0] - light[2][0];
  std::printf("red light through the ear: %.3f of the reference's\n", (light[1][0] - light[2][0]) / glow);
  EXPECT_NEAR((light[1][0] - light[2][0]) / glow, 1, 0.25);
  EXPECT_GT(glow, 5 * std::abs(light[1][1] - light[2][1]));  // it glows red
}

TEST_F(Ear, EveryLitPointIsThere) {
  RenderSettings s = ear_settings();
  s.lighting.rig_lights = 4;
  for (const double azimuth : {1.0, 60.0, 120.0, 180.0, 240.0}) {
    s.camera.name.clear();
    s.camera.orbit_deg = {azimuth, 10};
    const Statistics st = renderer().render(*scan, s).statistics;
    EXPECT_EQ(st.transmission_misses, 0u) << azimuth;
    EXPECT_EQ(st.unshaded_reads, 0u) << azimuth;
    EXPECT_TRUE(st.translucency);
  }
}

// The lit point faces away from the eye; what is not seen is still read.
TEST_F(Ear, TheOptimisationsAreNotMissed) {
  for (const double azimuth : {0.0, 330.0}) {  // 0: the scene's camera
    SCOPED_TRACE(azimuth);
    RenderSettings s = ear_settings();
    s.quality.map_size = 2048;  // with 1024 the narrowest terms of the whole map are texels wide
    if (azimuth != 0) s.camera.name.clear(), s.camera.orbit_deg = {azimuth, 0};
    s = super_sampled(s, 4);
    const Picture optimised = renderer().render(*scan, s), whole = renderer().render(*scan, unoptimised(s));
    expect_unseen(whole, optimised);
    EXPECT_LT(optimised.statistics.irradiance_texels, whole.statistics.irradiance_texels);
  }
}

// Skin that takes nothing from light before it scatters lets all of it in: a map of what enters would say so
// texel by texel. A share that is hardly above none draws that map, and the same picture.
TEST_F(Ear, WhereAllLightEntersNoMapSaysSo) {
  RenderSettings s = ear_settings();
  s.skin.mix = 0;
  const Picture without_map = renderer().render(*scan, s);
  s.skin.mix = 1e-7;
  const Picture with_map = renderer().render(*scan, s);

  EXPECT_LT(without_map.statistics.image_bytes, with_map.statistics.image_bytes);
  EXPECT_EQ(without_map.statistics.transmission_misses, 0u);
  EXPECT_GE(image::psnr_db(shown(with_map), shown(without_map)), 60);
}

}  // namespace
}  // namespace dermis::tests
