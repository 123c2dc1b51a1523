// SPDX-License-Identifier: MIT
// The table of skin is the model; a map's pigments are found again; other pigments change its colour as the
// model says, and nothing else.
#include "head/pigments/maps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dermis/error.h"
#include "head/pigments/coding.h"
#include "head/pigments/fit.h"
#include "head/scene/gltf/load.h"
#include "head/scene/import/shapes.h"
#include "image/codec.h"
#include "image/colour.h"
#include "support/assets.h"
#include "support/files.h"
#include "support/thrown.h"
#include "tissue/optics/skin_colour.h"

namespace dermis::pigments {
namespace {

using optics::Lab;
using optics::Pigments;
using optics::Rgb;

SpectralSkin skin_of(const Pigments& pigments) {
  SpectralSkin skin = optics::measured_skin();
  skin.melanin = pigments.melanin;
  skin.haemoglobin = pigments.haemoglobin;
  skin.oxygenation = pigments.oxygenation;
  return skin;
}
Lab lab_of(const std::array<float, 3>& albedo) {
  return optics::lab_from_linear({albedo[0], albedo[1], albedo[2]});
}

constexpr Pigments some[] = {{0.0015, 0.002, 0.75}, {0.02, 0.01, 0.75},  {0.025, 0.0137, 0.75},
                             {0.061, 0.0135, 0.75}, {0.11, 0.079, 0.75}, {0.3, 0.03, 0.75}};

// A ball whose colour map has one stripe for each of these skins, times an exposure.
scene::AssetData striped(double exposure = 1) {
  scene::AssetData ball = scene::sphere(0.1, 8);
  std::array<std::array<std::uint8_t, 4>, std::size(some)> colours{};
  for (std::size_t k = 0; k < colours.size(); ++k) {
    static const std::array<Rgb, std::size(some)> albedos = [] {
      std::array<Rgb, std::size(some)> all;
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = optics::skin_reflectance(skin_of(some[i]));
      return all;
    }();
    for (int c = 0; c < 3; ++c)
      colours[k][c] = image::linear_to_srgb8(static_cast<float>(exposure * albedos[k][c]));
    colours[k][3] = 255;
  }
  image::Image8 map{.width = 48, .height = 48, .rgba = {}};
  for (std::size_t i = 0; i < 48 * 48; ++i)
    map.rgba.insert(map.rgba.end(), colours[i % 48 / 8].begin(), colours[i % 48 / 8].end());
  ball.images = {{"stripes", std::make_shared<const image::Image8>(std::move(map))}};
  ball.materials[0].base_colour_map.image = 0;
  return ball;
}

Lab stripe(const scene::AssetData& scene, int number) {
  const image::Image8& map =
      *scene.images[static_cast<std::size_t>(scene.materials[0].base_colour_map.image)].pixels;
  return optics::lab_from_linear(linear_of(colour_at(map.at(8 * number + 3, 20))));
}

TEST(SkinTable, IsTheModel) {
  SpectralSkin fixed = optics::measured_skin();
  const optics::SkinTable table(fixed, {0.25, 0.5, 0.75, 1});
  for (const double oxygenation : {0.3, 0.75, 1.0})
    for (Pigments pigments : some) {
      pigments.oxygenation = oxygenation;
      const Lab wanted = optics::lab_from_linear(optics::skin_reflectance(skin_of(pigments)));
      EXPECT_LT(optics::delta_e76(lab_of(table.at(pigments)), wanted), 0.5)
          << pigments.melanin << " " << pigments.haemoglobin << " " << oxygenation;
    }
}

TEST(SkinTable, FindsPigmentsAgain) {
  for (const Pigments& pigments : some) {
    const auto found = table_of_maps().nearest(optics::skin_reflectance(skin_of(pigments)));
    EXPECT_LT(found.delta_e, 0.5);
    EXPECT_NEAR(std::log(found.pigments.melanin / pigments.melanin), 0, 0.06);
    EXPECT_NEAR(std::log(found.pigments.haemoglobin / pigments.haemoglobin), 0, 0.06);
  }
}

TEST(Coding, IsEvenInLogarithms) {
  EXPECT_EQ(melanin_coding.fraction(0), optics::least_melanin);
  EXPECT_NEAR(melanin_coding.fraction(255), optics::most_melanin, 1e-9);
  for (int code = 0; code < 256; ++code)
    EXPECT_EQ(haemoglobin_coding.code(haemoglobin_coding.fraction(static_cast<std::uint8_t>(code))), code);
}

TEST(Maps, HaveThePigmentsOfTheColours) {
  const Maps maps = maps_of(striped());
  EXPECT_EQ(maps.exposure, 1);
  EXPECT_GT(maps.texels, 1000u);
  EXPECT_LT(maps.model_delta_e.p95, 1);
  EXPECT_LT(maps.colour_delta_e.p95, 1);
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(std::log(melanin_coding.fraction(maps.melanin.at(8 * k + 3, 9)[0]) / some[k].melanin), 0,
                0.15)
        << k;
    EXPECT_NEAR(
        std::log(haemoglobin_coding.fraction(maps.haemoglobin.at(8 * k + 3, 9)[0]) / some[k].haemoglobin), 0,
        0.15)
        << k;
  }
}

// A picture of the same skin under half the light has the same pigments.
TEST(Maps, DoNotDependOnTheExposure) {
  const Maps maps = maps_of(striped(0.5));
  EXPECT_EQ(maps.exposure, 0.5);
  EXPECT_LT(maps.model_delta_e.p95, 1);
  EXPECT_NEAR(std::log(melanin_coding.fraction(maps.melanin.at(11, 9)[0]) / some[1].melanin), 0, 0.15);
}

// The prediction is the spectral model's own, wavelength by wavelength.
void expect_as_the_model_says(const Wanted& wanted) {
  scene::AssetData changed = striped();
  const scene::AssetData before = changed;
  repaint(changed, wanted);
  for (int k = 0; k < 6; ++k) {
    Pigments other = some[k];
    other.melanin = std::min(other.melanin * wanted.melanin, optics::most_melanin);
    other.haemoglobin = std::min(other.haemoglobin * wanted.haemoglobin, optics::most_blood);
    const Lab predicted = optics::lab_from_linear(optics::skin_reflectance(skin_of(other)));
    EXPECT_LT(optics::delta_e76(stripe(changed, k), predicted), 1.5) << k;
  }
}

TEST(Repaint, TwiceTheBloodReddensAsTheModelSays) {
  expect_as_the_model_says({.haemoglobin = 2});
  scene::AssetData changed = striped();
  const Lab before = stripe(changed, 2);
  repaint(changed, {.haemoglobin = 2});
  EXPECT_GT(stripe(changed, 2).a, before.a + 2);
  EXPECT_LT(stripe(changed, 2).l, before.l - 2);
}

TEST(Repaint, TwiceTheMelaninBrownsAsTheModelSays) {
  expect_as_the_model_says({.melanin = 2});
  scene::AssetData changed = striped();
  const Lab before = stripe(changed, 2);
  repaint(changed, {.melanin = 2});
  EXPECT_LT(stripe(changed, 2).l, before.l - 5);
  EXPECT_GT(stripe(changed, 2).b, before.b + 1);
}

TEST(Repaint, TakesTheMapsThatMapsOfMakes) {
  const tests::TempFolder folder;
  const std::string melanin = (folder.path() / "m.png").string(), blood = (folder.path() / "h.png").string();
  const scene::AssetData before = striped();
  const Maps maps = maps_of(before);
  image::save_png(melanin, maps.melanin);
  image::save_png(blood, maps.haemoglobin);

  scene::AssetData same = before, less = before;
  repaint(same, {.melanin_map = melanin, .haemoglobin_map = blood});
  repaint(less, {.haemoglobin_map = blood, .haemoglobin = 0.25});
  for (int k = 0; k < 6; ++k) {
    EXPECT_LT(optics::delta_e76(stripe(same, k), stripe(before, k)), 1) << k;
    if (k == 5) continue;  // hardly seen below much melanin
    EXPECT_LT(stripe(less, k).a, stripe(before, k).a) << k;
  }
}

TEST(Repaint, LeavesThePictureToOthersThatUseIt) {
  scene::AssetData scene = striped();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].skin = false;
  repaint(scene, {.melanin = 3});
  EXPECT_EQ(scene.materials[1].base_colour_map.image, 0);
  EXPECT_NE(scene.materials[0].base_colour_map.image, 0);
}

TEST(Repaint, RefusesWhatItCannotDo) {
  const tests::TempFolder folder;
  const std::string faulty = (folder.path() / "faulty.png").string();
  tests::write_text(faulty, "\x89PNG\r\n\x1a\nnothing more");
  scene::AssetData scene = striped();
  EXPECT_NE(tests::thrown<InputError>([&] { repaint(scene, {.melanin_map = faulty}); }).find("faulty.png"),
            std::string::npos);
  EXPECT_NE(tests::thrown<InputError>([&] {
              repaint(scene, {.haemoglobin_map = folder.path() / "missing.png"});
            }).find("missing.png"),
            std::string::npos);

  scene.images.push_back(scene.images[0]);
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].base_colour_map.image = 1;
  EXPECT_NE(tests::thrown<InputError>([&] { maps_of(scene); }).find("2 colour maps"), std::string::npos);
  EXPECT_NO_THROW(repaint(scene, {.melanin = 2})) << "factors are for all of them";

  for (scene::Material& material : scene.materials) material.base_colour_map.image = -1;
  EXPECT_NE(tests::thrown<InputError>([&] { repaint(scene, {.melanin = 2}); }).find("no colour map"),
            std::string::npos);
}

// Painted skin is none that two pigments alone could have; what render makes of the maps is.
TEST(MapsOfHeads, GiveTheColourBack) {
  for (const char* name : {"european-man", "african-man", "asian-woman"}) {
    const std::filesystem::path file =
        tests::asset_cache() / "makehuman" / (std::string("mh-") + name + "-young.glb");
    if (const std::string missing = tests::missing_asset({file}); !missing.empty()) GTEST_SKIP() << missing;
    const Maps maps = maps_of(scene::load_gltf(file));
    std::printf(
        "%-14s exposure %.2f, melanin %.3f, haemoglobin %.4f: %.2f dE, %.2f at 95 %%; the two pigments "
        "alone %.1f, %.1f\n",
        name, maps.exposure, maps.mean.melanin, maps.mean.haemoglobin, maps.colour_delta_e.mean,
        maps.colour_delta_e.p95, maps.model_delta_e.mean, maps.model_delta_e.p95);
    EXPECT_LT(maps.colour_delta_e.p95, 2);
  }
}

}  // namespace
}  // namespace dermis::pigments
