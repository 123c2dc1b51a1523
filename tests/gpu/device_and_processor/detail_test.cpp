// SPDX-License-Identifier: MIT
// A tile of detail: shaded as the same map would be in place of the normal map, by the device and by the
// reference; gone where its texels are smaller than pixels; nothing to skin that has none.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "dermis/reference.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/tangents.h"

namespace dermis::tests {
namespace {

constexpr float size_m = 0.1f;
constexpr int tile_side = 64, pixels = 128;

// Waves along both axes; they repeat.
image::Image8 waves() {
  image::Image8 map{.width = tile_side, .height = tile_side, .rgba = {}};
  const auto slope = [](int at) { return 0.4 * std::cos(6.283185307 * 3 * (at + 0.5) / tile_side); };
  for (int y = 0; y < tile_side; ++y)
    for (int x = 0; x < tile_side; ++x) {
      const glm::dvec3 n = glm::normalize(glm::dvec3(slope(x), slope(y), 1));
      for (int c = 0; c < 3; ++c)
        map.rgba.push_back(static_cast<std::uint8_t>(std::lround(127.5 * (n[c] + 1))));
      map.rgba.push_back(255);
    }
  return map;
}

enum class As { nothing, normal_map, detail };

// A plane under a slanting light, seen from above, with `tiles` of the waves along each axis.
Scene plane(As as, float tiles) {
  scene::AssetData made = scene::plane(size_m, glm::dmat2(1), {}, 4);
  made.images.push_back({.name = "waves", .pixels = std::make_shared<const image::Image8>(waves())});
  scene::MapRef map;
  map.image = 0;
  map.transform = glm::mat3x2(tiles, 0, 0, tiles, 0, 0);
  scene::Material& skin = made.materials.front();
  if (as == As::normal_map) skin.normal_map = map;
  if (as == As::detail) skin.skin_settings.detail = map;
  scene::make_tangents(made.primitives.front(), map.transform, 0);
  made.cameras.push_back(camera_from_above(size_m / 2, {0, 0, 0.2f}));
  made.lights = {directional_light({-0.6f, -0.2f, -0.77f}, glm::vec3(3))};
  return wrap(std::move(made));
}

RenderSettings settings(const std::string& technique) {
  RenderSettings s = small_settings(technique, pixels);
  s.output.bloom = 0;
  s.lighting.ambient = 0;
  s.quality.samples = 1;
  s.quality.light_samples = 1;  // of two, each shows maps of twice as many texels
  return s;
}

double largest_difference(const Picture& a, const Picture& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.linear_rgba.size(); ++i)
    largest = std::max(largest, double{std::abs(a.linear_rgba[i] - b.linear_rgba[i])});
  return largest;
}

// A pixel holds half a texel: the relief is whole, and tiles meet within the picture.
TEST(Detail, IsShadedAsANormalMap) {
  const RenderSettings s = settings("lambert");
  const Picture flat = renderer().render(plane(As::nothing, 1), s),
                wanted = renderer().render(plane(As::normal_map, 1), s),
                found = renderer().render(plane(As::detail, 1), s);
  EXPECT_GT(largest_difference(flat, wanted), 0.1);
  EXPECT_LT(largest_difference(found, wanted), 0.004);
}

// 0.5, 4 and 8 texels per pixel.
TEST(Detail, FadesAsItsTexelsBecomeSmallerThanPixels) {
  for (const std::string technique : {"texture-space", "separable", "pre-integrated"}) {
    SCOPED_TRACE(technique);
    const RenderSettings s = settings(technique);
    const Picture flat = renderer().render(plane(As::nothing, 1), s);
    const auto relief = [&](float tiles) {
      return largest_difference(flat, renderer().render(plane(As::detail, tiles), s));
    };
    const double whole = relief(1), fading = relief(8), gone = relief(17);
    EXPECT_GT(whole, 0.02);
    EXPECT_LT(fading, 0.8 * whole);
    EXPECT_LT(gone, 1e-3);
  }
}

TEST(DetailOfTheReference, IsShadedAsANormalMap) {
  RenderSettings s = settings("lambert");
  const Picture wanted = render_reference(plane(As::normal_map, 2), s, {.samples = 2}).picture,
                found = render_reference(plane(As::detail, 2), s, {.samples = 2}).picture,
                flat = render_reference(plane(As::nothing, 2), s, {.samples = 2}).picture;
  EXPECT_GT(largest_difference(flat, wanted), 0.1);
  EXPECT_LT(largest_difference(found, wanted), 1e-5);
}

}  // namespace
}  // namespace dermis::tests
