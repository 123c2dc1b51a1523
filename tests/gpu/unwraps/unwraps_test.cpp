// SPDX-License-Identifier: MIT
// Whatever the texture coordinates of a head: each pixel of it shows light that arrives there.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <string>

#include "gpu/support/failure.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "gpu/unwraps/made_up.h"
#include "head/scene/import/shapes.h"
#include "image/metrics.h"
#include "support/built_in.h"

namespace dermis::tests {
namespace {

TEST(Unwraps, EachReadFindsLight) {
  for (const MadeUp& made : made_up_unwraps()) {
    SCOPED_TRACE(made.name);
    RenderSettings s = tiny_settings(40, 64);
    PreparedFrame frame = renderer().prepare(wrap(made.scene), s);
    for (const auto& orbit_deg : {std::array{0.0, 0.0}, {75.0, 20.0}, {200.0, -40.0}}) {
      s.camera.orbit_deg = orbit_deg;
      frame.set(s);
      const Picture picture = frame.picture();
      EXPECT_EQ(picture.statistics.unshaded_reads, 0u) << orbit_deg[0] << ", " << orbit_deg[1];
      EXPECT_GT(picture.statistics.skin_pixels, 300u);
    }

    s.camera.fov_deg = 6;  // most of it is outside the picture
    frame.set(s);
    EXPECT_EQ(frame.picture().statistics.unshaded_reads, 0u) << "near";
  }
}

TEST(Unwraps, AWhiteFurnaceIsWhite) {
  for (const MadeUp& made : made_up_unwraps()) {
    SCOPED_TRACE(made.name);
    RenderSettings s = in_a_furnace(tiny_settings(40, 64));
    const SkinRange range = skin_range(renderer().render(wrap(made.scene), s));
    EXPECT_GT(range.pixels, 300u);
    // What EveryHead allows with reflection: half floats, and a directional albedo from a fit.
    EXPECT_GE(range.low, 0.99f);
    EXPECT_LE(range.high, 1.01f);
  }
}

// The fit takes back what the file has scaled, up to the rounding of its floats.
TEST(Unwraps, AScaledHeadLooksLikeItself) {
  const scene::AssetData head = kept_built_in_head(128);
  const RenderSettings s = tiny_settings(96, 192);
  const Picture plain = renderer().render(wrap(head), s);
  const std::pair<double, double> cases[]{{0.1, 0.0}, {0.001, 0.5}};
  for (const auto& [scale, offset] : cases) {
    const Picture scaled = renderer().render(wrap(moved(head, glm::dmat2(scale), glm::dvec2(offset))), s);
    std::vector<std::uint8_t> skin = skin_mask(plain);
    const std::vector<std::uint8_t> other = skin_mask(scaled);
    for (std::size_t i = 0; i < skin.size(); ++i) skin[i] |= other[i];
    const double psnr_db = image::psnr_db(display(plain), display(scaled), skin);
    std::cout << "scale " << scale << ", offset " << offset << ": " << psnr_db << " dB\n";
    EXPECT_GE(psnr_db, unseen_psnr_db) << "scale " << scale << ", offset " << offset;
  }
}

// Both halves of a sphere on the same texels, one of them mirrored: each shows its own light, and not that of
// the other, lit from the side.
TEST(Unwraps, HalvesOnTheSameTexelsShowTheirOwnLight) {
  const scene::AssetData sphere = scene::sphere(0.1, 12);
  scene::AssetData folded = sphere;
  for (scene::Primitive& primitive : folded.primitives)
    for (scene::Vertex& vertex : primitive.vertices) vertex.uv0.x = std::abs(2 * vertex.uv0.x - 1);

  RenderSettings s = tiny_settings(96, 384);
  s.quality.depth = false;
  s.lighting.placed_lights = {{.azimuth_deg = 70, .elevation_deg = 10, .irradiance = 3}};
  for (const double azimuth_deg : {0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0}) {
    s.camera.orbit_deg = {azimuth_deg, 0};
    const Picture own = renderer().render(wrap(sphere), s), shared = renderer().render(wrap(folded), s);
    const double psnr_db = image::psnr_db(display(own), display(shared), skin_mask(own));
    std::cout << azimuth_deg << " degrees: " << psnr_db << " dB\n";
    EXPECT_GE(psnr_db, 40) << write_failure(linear(own), linear(shared));
    EXPECT_EQ(shared.statistics.unshaded_reads, 0u);
  }
}

// Without texture coordinates nothing scatters, and all light is there: as the model without scattering has
// it.
TEST(Unwraps, SkinWithoutCoordinatesIsLitAtThePixel) {
  scene::AssetData sphere = moved(scene::sphere(0.1, 10), glm::dmat2(0));
  sphere.primitives[0].has_uv = false;
  RenderSettings s = tiny_settings(96, 64);
  s.skin.translucency = false;
  const Picture scattered = renderer().render(wrap(sphere), s);
  s.technique = "lambert";
  const Picture plain = renderer().render(wrap(sphere), s);
  EXPECT_EQ(scattered.display_rgba, plain.display_rgba) << write_failure(linear(plain), linear(scattered));
  EXPECT_GT(scattered.statistics.skin_pixels, 1000u);
}

}  // namespace
}  // namespace dermis::tests
