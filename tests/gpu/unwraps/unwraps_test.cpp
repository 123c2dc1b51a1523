// SPDX-License-Identifier: MIT
// Whatever the texture coordinates of a head: each pixel of it shows light that arrives there.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "builtin_head/builtin_head.h"
#include "gpu/unwraps/made_up.h"
#include "scene/primitives.h"

namespace dermis::tests {
namespace {

Scene wrap(scene::Scene data) { return Scene(std::make_shared<const scene::Scene>(std::move(data))); }

RenderSettings furnace(RenderSettings s) {
  s.lighting.ambient = 1;
  s.lighting.rig_lights = 0;
  s.lighting.white_albedo = true;
  return s;
}

struct Range {
  float low = 1e30f, high = -1e30f;
  int pixels = 0;
};

Range skin_range(const Picture& picture) {
  Range range;
  for (std::size_t i = 0; i + 3 < picture.linear_rgba.size(); i += 4) {
    if (picture.linear_rgba[i + 3] < 0.999f) continue;
    ++range.pixels;
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = picture.linear_rgba[i + c];
      range.low = std::min(range.low, value == value ? value : -1.0f);
      range.high = std::max(range.high, value == value ? value : 1e30f);
    }
  }
  return range;
}

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
  }
}

TEST(Unwraps, AWhiteFurnaceIsWhite) {
  for (const MadeUp& made : made_up_unwraps()) {
    SCOPED_TRACE(made.name);
    const Range range = skin_range(renderer().render(wrap(made.scene), furnace(tiny_settings(40, 64))));
    EXPECT_GT(range.pixels, 300);
    EXPECT_GE(range.low, 0.99f);
    EXPECT_LE(range.high, 1.01f);
  }
}

// The fit takes back what the file has scaled, up to the rounding of its floats.
TEST(Unwraps, AScaledHeadLooksLikeItself) {
  const scene::Scene head = builtin_head::make({.map_size = 128});
  const RenderSettings s = tiny_settings(96, 192);
  const Picture plain = renderer().render(wrap(head), s);
  const std::pair<double, double> cases[]{{0.1, 0.0}, {0.001, 0.5}};
  for (const auto& [scale, offset] : cases) {
    const Picture scaled = renderer().render(wrap(moved(head, glm::dmat2(scale), glm::dvec2(offset))), s);
    const double psnr_db = display_psnr_db(plain, scaled);
    std::cout << "scale " << scale << ", offset " << offset << ": " << psnr_db << " dB\n";
    EXPECT_GE(psnr_db, 40) << "scale " << scale << ", offset " << offset;
  }
}

// Without texture coordinates nothing scatters, and all light is there: as the model without scattering has
// it.
TEST(Unwraps, SkinWithoutCoordinatesIsLitAtThePixel) {
  scene::Scene sphere = moved(scene::sphere(0.1, 10), glm::dmat2(0));
  sphere.primitives[0].has_uv = false;
  RenderSettings s = tiny_settings(96, 64);
  s.skin.translucency = false;
  const Picture scattered = renderer().render(wrap(sphere), s);
  s.technique = "lambert";
  const Picture plain = renderer().render(wrap(sphere), s);
  EXPECT_EQ(scattered.display_rgba, plain.display_rgba);
  EXPECT_GT(scattered.statistics.skin_pixels, 1000u);
}

}  // namespace
}  // namespace dermis::tests
