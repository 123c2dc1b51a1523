// SPDX-License-Identifier: MIT
// Pictures of which the tiles that are seen are lit, against those of which all are, with every way of a
// frame.
#include <cstdio>
#include <cstring>
#include <functional>
#include <set>
#include <string>

#include "gpu/support/failure.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "image/metrics.h"

namespace dermis::tests {
namespace {

// All differs by what scatters from skin that nobody sees.
void expect_same(const Scene& scene, RenderSettings s, double least_db = 60) {
  const Picture seen = renderer().render(scene, s);
  s.quality.cull = s.quality.clip = false;
  const Picture all = renderer().render(scene, s);
  const double db = image::psnr_db(shown(all), shown(seen), skin_mask(all));
  std::printf("%.1f dB, %llu of %llu texels\n", db,
              static_cast<unsigned long long>(seen.statistics.irradiance_texels),
              static_cast<unsigned long long>(all.statistics.irradiance_texels));
  EXPECT_GE(db, least_db) << write_failure(linear(all), linear(seen));
  EXPECT_LT(seen.statistics.irradiance_texels, all.statistics.irradiance_texels);
  EXPECT_GT(seen.statistics.irradiance_texels, 0u);
  EXPECT_EQ(seen.statistics.skin_pixels, all.statistics.skin_pixels);
  EXPECT_EQ(seen.statistics.unshaded_reads, 0u);
  EXPECT_EQ(all.statistics.unshaded_reads, 0u);
  EXPECT_EQ(seen.statistics.transmission_misses, 0u);
}

std::set<std::string> passes_of(const Scene& scene, const RenderSettings& s) {
  std::set<std::string> names;
  for (const PassStatistics& pass : renderer().render(scene, s).statistics.passes) names.insert(pass.name);
  return names;
}

RenderSettings settings_at(double distance) {
  RenderSettings s = small_settings("texture-space", 128, 256);
  s.camera.distance = distance;
  s.output.bloom = 0;
  return s;
}

struct Way {
  std::string name;
  std::function<void(RenderSettings&)> set;
};

std::vector<Way> ways() {
  return {{"AsIs", [](RenderSettings&) {}},
          {"AtFullSize", [](RenderSettings& s) { s.quality.depth = false; }},
          {"Translucent", [](RenderSettings& s) { s.skin.translucency = true; }},
          {"ClippedOnly",
           [](RenderSettings& s) {
             s.quality.cull = s.quality.depth = false;
             s.quality.clip_margin_mm = 0;
             s.camera.fov_deg = 4;
           }},
          {"FourHeads",
           [](RenderSettings& s) {
             s.camera.heads = 4;
             s.output.width = 256;
           }},
          {"FourHeadsInBatches",
           [](RenderSettings& s) {
             s.camera.heads = 4;
             s.output.width = 256;
             s.quality.map_budget_mb = 8;
           }},
          {"InSurroundings", [](RenderSettings& s) {
             s.lighting.environment = "studio";
             s.lighting.light_radius_m = 0.1;
           }}};
}

class TexelPictures : public testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(Ways, TexelPictures, testing::ValuesIn(ways()),
                         [](const auto& way) { return way.param.name; });

TEST_P(TexelPictures, AreThoseOfAllTiles) {
  RenderSettings s = settings_at(3);
  GetParam().set(s);
  expect_same(subject("built-in head").open(), s);
}

// Two balls of one head, of other profiles, a light map each; the first of two materials, one of which is cut
// out: three lists.
scene::AssetData several_materials() {
  scene::AssetData made = scene::sphere(0.1, 16), front = scene::sphere(0.05, 16);
  image::Image8 pixels{.width = 64, .height = 64, .rgba = {}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto there = static_cast<std::uint8_t>(x % 16 < 8 ? 255 : 0);
      pixels.rgba.insert(pixels.rgba.end(), {220, 120, 90, there});
    }

  scene::Material cut = made.materials.front();
  cut.name = "cut";
  cut.alpha_mode = AssetAlpha::mask;
  cut.base_colour_map.image = static_cast<int>(made.images.size());
  made.images.push_back({.name = "mask", .pixels = std::make_shared<const image::Image8>(std::move(pixels))});
  scene::Material pale = made.materials.front();
  pale.name = "pale";
  pale.base_colour = {0.9f, 0.8f, 0.7f, 1};
  pale.skin_settings.profile = ScatterProfile{};
  pale.skin_settings.profile->name = "wide";
  pale.skin_settings.profile->terms = {{.variance_mm2 = 4, .weight = {0.5, 0.8, 0.9}},
                                       {.variance_mm2 = 40, .weight = {0.5, 0.2, 0.1}}};
  made.materials.push_back(cut);
  made.materials.push_back(pale);

  // Every second triangle of the first ball.
  scene::Primitive half = made.primitives.front();
  std::vector<std::uint32_t> kept, moved;
  for (std::size_t i = 0; i < half.indices.size(); i += 3)
    (i / 3 % 8 < 4 ? kept : moved)
        .insert((i / 3 % 8 < 4 ? kept : moved).end(), half.indices.begin() + static_cast<std::ptrdiff_t>(i),
                half.indices.begin() + static_cast<std::ptrdiff_t>(i + 3));
  made.primitives.front().indices = kept;
  half.indices = moved;
  half.material = 1;
  made.primitives.push_back(std::move(half));

  scene::Primitive ball = front.primitives.front();
  ball.material = 2;
  ball.node = 1;
  for (scene::Vertex& v : ball.vertices) v.position_m += glm::vec3(0.05f, 0.03f, 0.12f);
  made.primitives.push_back(std::move(ball));
  return made;
}

TEST(TexelPicturesOf, SeveralMaterials) {
  for (const bool translucency : {false, true}) {
    RenderSettings s = settings_at(3);
    s.skin.translucency = translucency;
    expect_same(wrap(several_materials()), s);
  }
}

// The skin meshes of a head take turns with one square: each turn lists the texels of another unwrap.
TEST(TexelPicturesOf, MeshesThatTakeTurns) {
  RenderSettings s = settings_at(3);
  s.quality.depth = false;
  s.quality.map_budget_mb = 7;
  const Scene scene = wrap(several_materials());
  expect_same(scene, s);
  EXPECT_EQ(passes_of(scene, s).count("tiles batch 1"), 1u);
}

TEST(TexelPicturesOf, HeadsOfTheLibrary) {
  for (const std::string name : {"scan", "MakeHuman", "ICT"}) {
    if (!subject(name).missing.empty()) continue;
    SCOPED_TRACE(name);
    RenderSettings s = settings_at(2.5);
    s.skin.translucency = true;
    expect_same(subject(name).open(), s, 50);
  }
}

// The order of the lists changes from run to run; no bit of the picture does.
TEST(TexelPicturesOf, TwoRunsAreEqualToTheBit) {
  RenderSettings s = settings_at(3);
  s.skin.translucency = true;
  const Picture first = renderer().render(subject("built-in head").open(), s);
  for (int i = 0; i < 3; ++i) {
    const Picture again = renderer().render(subject("built-in head").open(), s);
    ASSERT_EQ(first.linear_rgba.size(), again.linear_rgba.size());
    EXPECT_EQ(std::memcmp(first.linear_rgba.data(), again.linear_rgba.data(),
                          first.linear_rgba.size() * sizeof(float)),
              0);
  }
}

TEST(TexelPicturesOf, WhiteSkinInAWhiteFurnace) {
  const Picture p =
      renderer().render(subject("built-in head").open(), furnace_settings("texture-space", true));
  const SkinRange skin = skin_range(p);
  EXPECT_GT(skin.pixels, 1000u);
  EXPECT_GE(skin.low, 0.98f);
  EXPECT_LE(skin.high, 1.02f);
}

}  // namespace
}  // namespace dermis::tests
