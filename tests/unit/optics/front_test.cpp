// SPDX-License-Identifier: MIT
// The public header alone, as a program outside would use it; and what the profile file holds in the end.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "dermis/error.h"
#include "dermis/profile.h"
#include "tissue/gaussians/json.h"

namespace dermis {
namespace {

double sum_of_weights(const ScatterProfile& profile, int c) {
  double sum = 0;
  for (const Gaussian& term : profile.terms) sum += term.weight[c];
  return sum;
}

TEST(PublicProfile, PresetsAndFiles) {
  const ScatterProfile skin = profile_of_preset("skin1", {.model = ProfileModel::dipole});
  ASSERT_EQ(skin.terms.size(), 6u);
  EXPECT_NEAR(skin.total_reflectance[0], 0.4360, 1e-4);
  EXPECT_NEAR(skin.diffuse_mean_free_path_mm[2], 0.683, 1e-3);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum_of_weights(skin, c), 1, 1e-9);
  const auto file = std::filesystem::temp_directory_path() / "dermis_front_test.json";
  write_profile(skin, file.string());
  const ScatterProfile read = gaussians::load_json(file);
  EXPECT_EQ(read.name, "skin1");
  EXPECT_EQ(read.model, "dipole");
  ASSERT_EQ(read.terms.size(), 6u);
  EXPECT_EQ(read.terms[3].variance_mm2, skin.terms[3].variance_mm2);
  std::filesystem::remove(file);
}

TEST(PublicProfile, SkinAndColours) {
  double delta_e = 99;
  const SpectralSkin pale = skin_of_colour("65,7.1,13.3", &delta_e),
                     dark = skin_of_colour("38.14,12.66,15.04");
  EXPECT_LT(delta_e, 4);
  EXPECT_LT(pale.melanin, dark.melanin);
  const ScatterProfile a = profile_of_skin(pale, {.gaussians = 4, .photons = 20'000}),
                       b = profile_of_skin(pale, {.gaussians = 4, .photons = 20'000});
  EXPECT_EQ(a.terms, b.terms);
  EXPECT_NE(a.model.find("Monte-Carlo"), std::string::npos);
  EXPECT_GT(a.total_reflectance[0], a.total_reflectance[2]);
}

// Photon beam diffusion of a pale medium without a boundary gives more light back than entered; the exact
// total is 0.9128.
TEST(PublicProfile, CutTotalsAreNotHidden) {
  const ScatterProfile beam = profile_of_coefficients({{.001, .001, .001}, {.999, .999, .999}, 0, 1},
                                                      {.gaussians = 2, .model = ProfileModel::beam});
  EXPECT_EQ(beam.total_reflectance[0], 1);
  EXPECT_NEAR(beam.model_total[0], 1.0057, 1e-3);
  const ScatterProfile dipole = profile_of_preset("skin1", {.gaussians = 2, .model = ProfileModel::dipole});
  EXPECT_EQ(dipole.model_total, dipole.total_reflectance);
}

TEST(PublicProfile, MinusZeroIsZero) {
  const ScatterProfile clear = profile_of_coefficients({{-0.0, -0.0, -0.0}, {1, 1, 1}},
                                                       {.gaussians = 2, .model = ProfileModel::dipole});
  EXPECT_EQ(clear.diffuse_mean_free_path_mm[0], 0);  // unknown, not -inf
}

template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const InputError& error) { return error.what(); }
  return "";
}

TEST(PublicProfile, MistakesAreNamed) {
  EXPECT_EQ(refusal([] { profile_of_preset("skin1", {.gaussians = 9}); }), "gaussians must be 1 to 8, got 9");
  EXPECT_EQ(refusal([] {
              profile_of_coefficients({{1, 1, -1}, {1, 1, 1}});
            }),
            "sigma_a_per_mm must be 0 to 1000000 per mm, got -1");
  EXPECT_EQ(refusal([] { profile_of_skin({.melanin = 2}); }), "melanin must be 0 to 0.5, got 2");
  EXPECT_THROW(profile_of_preset("skin3"), InputError);
  EXPECT_THROW(profile_of_preset("skin1", {.gaussians = 0, .model = ProfileModel::dipole}), InputError);
  EXPECT_THROW(profile_of_coefficients({{-1, 1, 1}, {1, 1, 1}}), InputError);
  EXPECT_THROW(profile_of_coefficients({{1, 1, 1}, {1, 1, 1}, 1.0}), InputError);
  EXPECT_THROW(profile_of_skin({.melanin = 2}), InputError);
  try {
    profile_of_coefficients({{1, 1, 1}, {1, 0, 1}}, {.model = ProfileModel::dipole});
    FAIL() << "a black channel has no profile";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("coefficients: green: reflects nothing"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace dermis
