// SPDX-License-Identifier: MIT
// Spectral skin against measured skin, and as profiles.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/core/error.h"
#include "support/sanitized.h"
#include "tissue/optics/radiative.h"
#include "tissue/optics/skin_colour.h"
#include "tissue/profile/spectral.h"
#include "unit/optics/measured_skin.h"

namespace dermis {
namespace {

TEST(SkinColour, MeasuredGroupsLieNearTheModel) {
  const std::size_t every = tests::turns<std::size_t>(1, 5);
  for (std::size_t i = 0; i < std::size(measured_skins); i += every) {
    const MeasuredSkin& group = measured_skins[i];
    const optics::SkinMatch match = optics::nearest_skin(group.lab);
    std::printf("%-24s melanin %.4f haemoglobin %.4f  dE %.2f\n", group.name, match.skin.melanin,
                match.skin.haemoglobin, match.delta_e);
    EXPECT_LT(match.delta_e, 4) << group.name;
  }
}

TEST(SkinColour, FindsItsOwnColours) {
  for (const double melanin : {0.01, 0.1})
    for (const double blood : {0.005, 0.03}) {
      SpectralSkin skin = optics::measured_skin();
      skin.melanin = melanin, skin.haemoglobin = blood;
      const optics::SkinMatch match =
          optics::nearest_skin(optics::lab_from_linear(optics::skin_colour(skin)));
      EXPECT_LT(match.delta_e, 0.5);
      EXPECT_NEAR(match.skin.melanin / melanin, 1, 0.1);
      EXPECT_NEAR(match.skin.haemoglobin / blood, 1, 0.2);
    }
}

// The colours of skin fold back on themselves; these two are met in the other fold than the nearest grid
// point's, one by swatches at 5.0 and 9.8 dE.
TEST(SkinColour, FindsTheBetterFold) {
  EXPECT_LT(optics::nearest_skin({28.1595, 0.3932, 3.7488}, SpectralSkin{}).delta_e, 5.0);
  EXPECT_LT(optics::nearest_skin({49.7161, -3.8881, 12.5156}, SpectralSkin{}).delta_e, 9.8);
}

TEST(SkinColour, CoarseAndFineAgree) {
  for (const double nm : {420.0, 550.0, 650.0})
    for (const double melanin : {0.005, 0.3}) {
      const optics::Layers layers = optics::skin_layers({.melanin = melanin}, nm);
      EXPECT_NEAR(optics::adding_doubling_coarse(layers).reflectance,
                  optics::adding_doubling(layers).reflectance, 2e-3);
    }
}

TEST(SkinColour, TextIsReadOrRefused) {
  EXPECT_NEAR(optics::parse_colour("#ffffff", "x").l, 100, 1e-6);
  EXPECT_NEAR(optics::parse_colour("65,7.1,13.3", "x").b, 13.3, 1e-12);
  for (const char* bad : {"#fff", "#gggggg", "c58c85", "1,2", "1,2,3,4", "101,0,0", "", "a,b,c", "#12345678"})
    EXPECT_THROW(optics::parse_colour(bad, "--colour"), InputError) << bad;
}

TEST(SpectralProfile, IntegratesToTheColour) {
  const SpectralSkin skin{.melanin = 0.01};
  const optics::Rgb colour = optics::skin_reflectance(skin);
  const auto diffusion = profile::make_profiles(skin, profile::Model::multipole, {}, "test");
  const auto photons = profile::make_profiles(skin, profile::Model::automatic,
                                              {.photons = 100'000, .seed = 1, .cache = {}}, "test");
  EXPECT_EQ(photons.model, profile::Model::monte_carlo);
  EXPECT_NE(photons.reason.find("nm"), std::string::npos);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(diffusion.profiles[c]->total() / colour[c], 1, 1e-9);
    EXPECT_NEAR(photons.profiles[c]->total() / colour[c], 1, 1e-9);
    EXPECT_NEAR(photons.profiles[c]->within(photons.profiles[c]->quantile(0.5)), 0.5 * colour[c], 1e-3);
  }
  // Red light goes farthest
  EXPECT_GT(photons.profiles[0]->quantile(0.5), photons.profiles[1]->quantile(0.5));
  EXPECT_GT(photons.profiles[1]->quantile(0.5), photons.profiles[2]->quantile(0.5));
  EXPECT_THROW(profile::make_profiles(skin, profile::Model::dipole, {}, "test"), InputError);
}

TEST(Model, AutomaticSaysWhatDecided) {
  const profile::MonteCarloOptions few{.photons = 1000, .seed = 1, .cache = {}};
  const auto chosen = [&](const optics::RgbLayers& layers) {
    return profile::make_profiles(layers, profile::Model::automatic, few, "test");
  };
  const optics::RgbLayer thick{{.01, .01, .01}, {2, 2, 2}, 1.4, 5}, dark{{1, 1, 1}, {2, 2, 2}, 1.4, 5},
      thin{{.01, .01, .01}, {2, 2, 2}, 1.4, .1};

  EXPECT_EQ(chosen({thick, thick}).model, profile::Model::multipole);
  EXPECT_EQ(chosen({thick, dark}).model, profile::Model::monte_carlo);
  EXPECT_NE(chosen({thick, dark}).reason.find("0.667 (layer 1, red)"), std::string::npos);
  EXPECT_EQ(chosen({thin, thick}).model, profile::Model::monte_carlo);
  EXPECT_NE(chosen({thin, thick}).reason.find("0.20 mean free paths (layer 0, red)"), std::string::npos);

  optics::RgbMedium pale;
  for (auto& medium : pale) medium = {.sigma_a_per_mm = .01, .sigma_s_per_mm = 1};
  EXPECT_EQ(profile::make_profiles(pale, profile::Model::automatic, few, "test").model,
            profile::Model::dipole);
  pale[1].sigma_a_per_mm = 1;
  const auto mixed = profile::make_profiles(pale, profile::Model::automatic, few, "test");
  EXPECT_EQ(mixed.model, profile::Model::monte_carlo);
  EXPECT_NE(mixed.reason.find("0.500 (green)"), std::string::npos);

  EXPECT_THROW(profile::make_profiles(optics::RgbLayers{thick}, profile::Model::beam, few, "test"),
               InputError);

  // Spectral skin without melanin and blood: pale enough for diffusion, if the epidermis is thick enough
  const auto skin = [&](double epidermis_mm) {
    return profile::make_profiles(SpectralSkin{.melanin = 0, .haemoglobin = 0, .epidermis_mm = epidermis_mm},
                                  profile::Model::automatic, few, "test");
  };
  EXPECT_EQ(skin(1).model, profile::Model::multipole);
  const auto film = skin(0.01);
  EXPECT_EQ(film.model, profile::Model::monte_carlo);
  EXPECT_NE(film.reason.find("the epidermis measures 0.04 mean free paths (700 nm), under 2"),
            std::string::npos);
}

}  // namespace
}  // namespace dermis
