// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "dermis/error.h"
#include "viewer/model/skin_maker.h"

namespace dermis::viewer {
namespace {

SkinSource source_of(SkinKind kind) {
  SkinSource source;
  source.kind = kind;
  source.options.model = ProfileModel::multipole;
  return source;
}

TEST(Skin, IsThatOfTheLibrary) {
  SkinSource source = source_of(SkinKind::preset);
  source.preset = "marble";
  source.options.model = ProfileModel::dipole;
  const MadeSkin made = make_skin(source, false, {});
  const ScatterProfile wanted = profile_of_preset("marble", source.options);
  EXPECT_EQ(made.profile.terms, wanted.terms);
  EXPECT_FALSE(made.is_quick);
}

TEST(Skin, OfCoefficientsComesToTheLastBit) {
  SkinSource source = source_of(SkinKind::coefficients);
  source.options.model = ProfileModel::dipole;
  source.coefficients = {.sigma_a_per_mm = {0.032, 0.17, 0.48}, .sigma_s_per_mm = {1.0 / 1.3, 0.88, 1.01}};
  const MadeSkin made = make_skin(source, false, {});
  EXPECT_EQ(made.profile.terms, profile_of_coefficients(source.coefficients, source.options).terms);
}

TEST(Skin, OfMorePigmentSpreadsLess) {
  SkinSource source = source_of(SkinKind::spectral);
  source.spectral.haemoglobin = 0.002;
  const double pale = make_skin(source, true, {}).profile.total_reflectance[1];
  source.spectral.haemoglobin = 0.05;
  const double red = make_skin(source, true, {}).profile.total_reflectance[1];
  EXPECT_LT(red, pale);
  // The curve of the model comes with the better one.
  EXPECT_TRUE(make_skin(source, true, {}).curves.model.empty());
  EXPECT_TRUE(needs_better(source));
}

TEST(Skin, QuickIsDiffusionAndABetterOneFollows) {
  SkinSource source = source_of(SkinKind::preset);
  source.preset = "skin1";
  source.options.model = ProfileModel::automatic;
  EXPECT_TRUE(needs_better(source));
  const MadeSkin made = make_skin(source, true, {});
  EXPECT_TRUE(made.is_quick);
  EXPECT_EQ(made.profile.noise_percent, (std::array<double, 3>{}));
  source.options.model = ProfileModel::beam;
  EXPECT_FALSE(needs_better(source));
}

TEST(Skin, CurvesAreThoseOfTheProfile) {
  SkinSource source = source_of(SkinKind::gaussians);
  source.gaussians = load_profile("skin");
  const MadeSkin made = make_skin(source, false, {});
  ASSERT_EQ(made.curves.r_mm.size(), made.curves.fit.size());
  EXPECT_TRUE(made.curves.model.empty());
  for (std::size_t i = 0; i < made.curves.r_mm.size(); i += 17)
    EXPECT_EQ(made.curves.fit[i], reflectance(source.gaussians, made.curves.r_mm[i]));
  EXPECT_THROW(exported_skin(made, "unity"), InputError);
}

TEST(Skin, OfAnotherEngineAndBack) {
  SkinSource source = source_of(SkinKind::foreign);
  source.options.model = ProfileModel::automatic;
  source.foreign = "unity reflectance=0.8,0.5,0.4 scattering_distance=0.76,0.32,0.2";
  const MadeSkin made = make_skin(source, true, {});
  EXPECT_GT(made.profile.terms.back().variance_mm2, 0.1);
  // 0.32 / 0.76: lengths of the channels, by the longest.
  EXPECT_NE(exported_skin(made, "unity").find("0.421052631"), std::string::npos);
  source.foreign = "unity radius=1,2,3";
  EXPECT_THROW(make_skin(source, true, {}), InputError);
}

TEST(Skin, TheMakerEndsWithTheNewestWish) {
  SkinMaker maker({});
  SkinSource source = source_of(SkinKind::spectral);
  for (int i = 1; i <= 5; ++i) {
    source.spectral.melanin = 0.01 * i;
    maker.want(source);
  }
  std::optional<MadeSkin> last;
  while (maker.is_running())
    if (std::optional<MadeSkin> made = maker.take())
      last = std::move(made);
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  if (std::optional<MadeSkin> made = maker.take()) last = std::move(made);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->profile.terms, make_skin(source, true, {}).profile.terms);
}

}  // namespace
}  // namespace dermis::viewer
