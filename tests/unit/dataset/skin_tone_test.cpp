// SPDX-License-Identifier: MIT
// The class of a skin, out of its colour map.
#include "tools/dataset/skin_tone.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "dermis/asset_arrays.h"

namespace dermis::dataset {
namespace {

TEST(SkinTone, ClassesEndWhereTheyDo) {
  EXPECT_STREQ(ita_class(90), "very light");
  EXPECT_STREQ(ita_class(55.1), "very light");
  EXPECT_STREQ(ita_class(55), "light");
  EXPECT_STREQ(ita_class(41), "intermediate");
  EXPECT_STREQ(ita_class(28), "tan");
  EXPECT_STREQ(ita_class(10), "brown");
  EXPECT_STREQ(ita_class(-30), "dark");
  EXPECT_STREQ(ita_class(-90), "dark");
}

// Their pigments are those of a measured skin in each class; lips, stubble and the rest do not move it.
TEST(SkinTone, ClassesOfTheBuiltInHeadAreFoundInItsMap) {
  for (const auto& [name, wanted] :
       std::array<std::array<const char*, 2>, 6>{{{"very-light", "very light"},
                                                  {"light", "light"},
                                                  {"intermediate", "intermediate"},
                                                  {"tan", "tan"},
                                                  {"brown", "brown"},
                                                  {"dark", "dark"}}}) {
    const std::optional<double> angle = ita_deg_of(Asset::load("built-in:ita-" + std::string(name)));
    ASSERT_TRUE(angle);
    std::printf("%s: %.1f degrees\n", name, *angle);
    EXPECT_STREQ(ita_class(*angle), wanted) << *angle;
  }
}

TEST(SkinTone, TheMedianIsByArea) {
  const std::array<std::array<float, 3>, 6> points{
      {{0, 0, 0}, {0.3f, 0, 0}, {0, 0.3f, 0}, {0, 0, 1}, {0.1f, 0, 1}, {0, 0.1f, 1}}};
  std::array<std::array<float, 4>, 6> colours{};
  for (std::size_t i = 0; i < 6; ++i)
    colours[i] = i < 3 ? std::array{0.6f, 0.4f, 0.3f, 1.0f} : std::array{0.02f, 0.01f, 0.005f, 1.0f};
  const std::array<std::uint32_t, 6> indices{0, 1, 2, 3, 4, 5};
  AssetArrays arrays;
  arrays.materials.resize(2);
  arrays.materials[0].skin = true;
  arrays.materials[1].skin = false;
  AssetMesh mesh{.name = "face", .material = 0, .positions_m = points, .indices = indices};
  mesh.colours = colours;
  arrays.meshes = {mesh};
  const std::optional<double> angle = ita_deg_of(Asset::from_arrays(arrays));
  ASSERT_TRUE(angle);
  EXPECT_GT(*angle, 10) << "the large triangle is fair";

  arrays.meshes[0].material = 1;
  EXPECT_FALSE(ita_deg_of(Asset::from_arrays(arrays))) << "no skin";
}

}  // namespace
}  // namespace dermis::dataset
