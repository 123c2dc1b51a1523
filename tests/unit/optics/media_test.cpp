// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "base/core/error.h"
#include "tissue/optics/fresnel.h"
#include "tissue/optics/inversion.h"
#include "tissue/optics/layers.h"
#include "tissue/optics/presets.h"
#include "tissue/profile/dipole.h"
#include "tissue/profile/tabulated.h"
#include "truth.h"

namespace dermis {
namespace {

using optics::Medium;

template <class Call>
std::string message_of(Call&& call) {
  try {
    call();
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

TEST(Media, CoefficientsFollowFromTheMedium) {
  const Medium medium{.sigma_a_per_mm = 0.1, .sigma_s_per_mm = 5, .g = 0.8, .eta = 1.4};
  EXPECT_NEAR(medium.sigma_s_reduced_per_mm(), 1.0, 1e-12);
  EXPECT_NEAR(medium.sigma_t_reduced_per_mm(), 1.1, 1e-12);
  EXPECT_NEAR(medium.reduced_albedo(), 1 / 1.1, 1e-12);
  EXPECT_NEAR(medium.mean_free_path().mm, 1 / 1.1, 1e-12);
  EXPECT_NEAR(medium.diffuse_mean_free_path().mm, 1 / std::sqrt(3 * 0.1 * 1.1), 1e-12);
}

TEST(Media, MinusZeroIsZero) {
  const auto medium = optics::parse_coefficients("sigma_a=-0 sigma_s=1", "test");
  EXPECT_FALSE(std::signbit(medium[0].sigma_a_per_mm));
  EXPECT_EQ((Medium{.sigma_a_per_mm = -0.0, .sigma_s_per_mm = 1}.diffuse_mean_free_path().mm), HUGE_VAL);
  const auto layers =
      optics::parse_layers(R"([{"sigma_a_per_mm":[-0.0,0.1,-0],"sigma_s_reduced_per_mm":1}])", "test");
  for (const int c : {0, 2}) EXPECT_FALSE(std::signbit(layers[0].sigma_a_per_mm[c]));
}

TEST(Media, TheTwoMeanFreePathsDoNotConvert) {
  static_assert(!std::is_convertible_v<double, optics::MeanFreePath>);
  static_assert(!std::is_convertible_v<optics::MeanFreePath, optics::DiffuseMeanFreePath>);
  static_assert(!std::is_constructible_v<optics::MeanFreePath, optics::DiffuseMeanFreePath>);
}

TEST(Media, BadCoefficientsAreNamed) {
  const auto parse = [](const char* text) {
    return message_of([&] { optics::parse_coefficients(text, "--coefficients"); });
  };
  EXPECT_NE(parse("sigma_a=-1,1,1 sigma_s=1").find("sigma_a_per_mm must be 0 to"), std::string::npos);
  EXPECT_NE(parse("sigma_a=1 sigma_s=1 g=1").find("g must be above -1 and below 1, got 1"),
            std::string::npos);
  EXPECT_NE(parse("sigma_a=1 sigma_s=1 eta=0.9").find("eta must be 1 to 3, got 0.9"), std::string::npos);
  EXPECT_NE(parse("sigma_a=1 sigma_s=1 sigma_t=2").find("there are: sigma_a, sigma_s, g, eta"),
            std::string::npos);
  EXPECT_NE(parse("sigma_a=1,2 sigma_s=1").find("one number or three"), std::string::npos);
  EXPECT_NE(parse("sigma_a=nan sigma_s=1").find("sigma_a_per_mm must be"), std::string::npos);
  EXPECT_NE(parse("sigma_a=0 sigma_s=0").find("both 0"), std::string::npos);
  EXPECT_NE(parse("sigma_a=1").find("'sigma_s' is missing"), std::string::npos);
  EXPECT_NE(parse("sigma_a=1 sigma_a=1 sigma_s=1").find("twice"), std::string::npos);
  EXPECT_NE(parse("sigma_a=1mm sigma_s=1").find("not a number"), std::string::npos);
}

// Independent quadrature, printed to six digits.
TEST(Fresnel, MomentsAndBoundaryFactors) {
  struct Row {
    double n, poly, c1, c2, classical;
  };
  for (const Row& row :
       {Row{1.1, .193332, .194345, .087920, 1.47933}, Row{1.2, .335987, .336306, .198496, 2.01199},
        Row{1.3, .444763, .444457, .300267, 2.60206}, Row{1.33, .472357, .471949, .328239, 2.79044},
        Row{1.37, .506158, .505673, .363635, 3.04988}, Row{1.4, .529489, .528985, .388783, 3.25070},
        Row{1.5, .596733, .596346, .464430, 3.95950}}) {
    EXPECT_NEAR(optics::fresnel_diffuse_polynomial(row.n), row.poly, 1e-6) << row.n;
    EXPECT_NEAR(optics::fresnel_moment_2c1(row.n), row.c1, 1e-6) << row.n;
    EXPECT_NEAR(optics::fresnel_moment_3c2(row.n), row.c2, 1e-6) << row.n;
    EXPECT_NEAR(optics::boundary_factor_classical(row.n), row.classical, 1e-5) << row.n;
  }

  struct Outside {
    double n, c1, poly;
  };
  for (const Outside& row :
       {Outside{1.3, .061132, .061788}, Outside{1.4, .076812, .077954}, Outside{1.5, .091778, .092825}}) {
    EXPECT_NEAR(optics::fresnel_moment_2c1(1 / row.n), row.c1, 1e-6) << row.n;
    EXPECT_NEAR(optics::fresnel_diffuse_polynomial(1 / row.n), row.poly, 1e-6) << row.n;
  }

  EXPECT_EQ(optics::boundary_factor_classical(1), 1);
  EXPECT_NEAR(optics::fresnel(1, 1.4), (0.4 / 2.4) * (0.4 / 2.4), 1e-12);
  EXPECT_EQ(optics::fresnel(0.1, 1.4), 1);
}

TEST(Presets, TotalsOfEveryMeasuredMaterial) {
  for (std::size_t i = 0; i < truth::totals.size(); ++i) {
    const optics::Material& material = optics::jensen_materials()[i];
    ASSERT_EQ(material.name, truth::totals[i].material);
    for (int c = 0; c < 3; ++c) {
      const profile::Dipole dipole(material.medium()[c]);
      EXPECT_NEAR(dipole.total(), truth::totals[i].computed[c], 1e-4) << material.name << c;
      EXPECT_EQ(material.published_reflectance[c], truth::totals[i].published[c]) << material.name << c;
      EXPECT_NEAR(dipole.total(), truth::totals[i].published[c],
                  material.name == "chicken1" && c == 2 ? 0.03 : 0.02)
          << material.name << c;
      EXPECT_NEAR(dipole.total(),
                  optics::dipole_total_reflectance(material.medium()[c].reduced_albedo(), material.eta),
                  1e-12);
    }
  }
}

TEST(Presets, UnknownNamesListTheKnown) {
  const std::string message = message_of([] { optics::unknown_preset("skin3"); });
  EXPECT_NE(message.find("'skin3'"), std::string::npos);
  EXPECT_NE(message.find("skin1, skin2"), std::string::npos);
  EXPECT_NE(message.find("skin-layers"), std::string::npos);
}

TEST(Inversion, GivesTheCoefficientsBack) {
  for (const optics::Material& material : optics::jensen_materials()) {
    if (material.name == "spectralon") continue;
    for (const Medium& medium : material.medium()) {
      const double total = profile::Dipole(medium).total();
      const Medium by_mfp =
          optics::medium_from_reflectance(total, medium.mean_free_path(), medium.eta, "test");
      const Medium by_dmfp =
          optics::medium_from_reflectance(total, medium.diffuse_mean_free_path(), medium.eta, "test");
      for (const Medium& found : {by_mfp, by_dmfp}) {
        EXPECT_NEAR(found.sigma_a_per_mm / medium.sigma_a_per_mm, 1, 1e-6);
        EXPECT_NEAR(found.sigma_s_per_mm / medium.sigma_s_per_mm, 1, 1e-6);
      }
    }
  }
  EXPECT_THROW(optics::medium_from_reflectance(1.1, optics::MeanFreePath(1), 1.4, "test"), InputError);
  EXPECT_THROW(optics::medium_from_reflectance(0.5, optics::MeanFreePath(0), 1.4, "test"), InputError);
  EXPECT_THROW(optics::medium_from_reflectance(1, optics::DiffuseMeanFreePath(1), 1.4, "test"), InputError);
}

TEST(Layers, FilesAreCheckedKeyByKey) {
  const auto parse = [](const char* json) {
    return message_of([&] { optics::parse_layers(json, "skin.json"); });
  };

  const auto layers = optics::parse_layers(
      R"([{"sigma_a_per_mm":[0.1,0.2,0.3],"sigma_s_reduced_per_mm":2,"thickness_mm":0.25},
                                              {"sigma_a_per_mm":0.1,"sigma_s_reduced_per_mm":1,"eta":1.38}])",
      "skin.json");
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].sigma_a_per_mm[2], 0.3);
  EXPECT_EQ(layers[0].eta, 1.4);
  EXPECT_EQ(layers[1].eta, 1.38);
  EXPECT_TRUE(std::isinf(layers[1].thickness_mm));

  EXPECT_NE(parse("[]").find("1 to 32 layers, got 0"), std::string::npos);
  // One line, whatever a key holds.
  EXPECT_NE(parse(R"([{"a\nb":1}])").find("unknown key 'a?b'"), std::string::npos);
  EXPECT_NE(parse("{").find("not valid JSON"), std::string::npos);
  EXPECT_NE(parse("{}").find("must be an array"), std::string::npos);
  EXPECT_NE(parse(R"([{"sigma_a":1}])").find("layer 0: unknown key 'sigma_a'; there are: sigma_a_per_mm"),
            std::string::npos);
  EXPECT_NE(parse(R"([{"eta":1.3,"eta":1.4}])").find("'eta' is given twice"), std::string::npos);
  EXPECT_NE(parse(R"([{"eta":1e999}])").find("skin.json: is not valid JSON: number overflow"),
            std::string::npos);
  EXPECT_NE(parse(std::string(100'000, '[').c_str()).find("nested deeper than 3 levels"), std::string::npos);

  EXPECT_NE(parse(R"([{"sigma_a_per_mm":1}])").find("'sigma_s_reduced_per_mm' is missing"),
            std::string::npos);
  EXPECT_NE(parse(
                R"([{"sigma_a_per_mm":1,"sigma_s_reduced_per_mm":1},
              {"sigma_a_per_mm":1,"sigma_s_reduced_per_mm":1}])")
                .find("only the last"),
            std::string::npos);

  EXPECT_NE(parse(R"([{"sigma_a_per_mm":1,"sigma_s_reduced_per_mm":"x"}])")
                .find("layer 0.sigma_s_reduced_per_mm: must be a number or [R, G, B]"),
            std::string::npos);
  EXPECT_NE(parse(R"([{"sigma_a_per_mm":1,"sigma_s_reduced_per_mm":1,"thickness_mm":-1}])")
                .find("thickness_mm must be above 0"),
            std::string::npos);
  EXPECT_NE(parse(R"([{"sigma_a_per_mm":0,"sigma_s_reduced_per_mm":1,"thickness_mm":1e155}])")
                .find("layer 0: thickness_mm must be at most 1e+06"),
            std::string::npos);
  EXPECT_NE(
      parse(R"([{"sigma_a_per_mm":1,"sigma_s_reduced_per_mm":1,"eta":0.5}])").find("eta must be 1 to 3"),
      std::string::npos);
}

TEST(Tabulated, ReadsWhatItShouldAndNothingElse) {
  const auto parse = [](const char* text) { return message_of([&] { profile::parse_csv(text, "r.csv"); }); };
  EXPECT_NE(parse("").find("empty"), std::string::npos);
  EXPECT_NE(parse("r_mm,R,G,B\n").find("at least two rows"), std::string::npos);
  EXPECT_NE(parse("r,R,G,B\n0,1,1,1\n1,1,1,1\n").find("line 1: expected the header"), std::string::npos);
  EXPECT_NE(parse("r_mm,R,G,B\n1,1,1,1\n0.5,1,1,1\n").find("line 3: radii must rise"), std::string::npos);
  EXPECT_NE(parse("r_mm,R,G,B\n1,1,1\n").find("line 2: expected four numbers"), std::string::npos);
  EXPECT_NE(parse("r_mm,R,G,B\n0,1,1,1,1\n").find("line 2"), std::string::npos);
  EXPECT_NE(parse("r_mm,R,G,B\n0,-1,1,1\n1,1,1,1\n").find("0 to 1e12"), std::string::npos);
  EXPECT_NE(parse("r_mm,R,G,B\n0,x,1,1\n").find("'x' is not a number"), std::string::npos);
  EXPECT_NE(parse("r_mm,R,G,B\n0,\x7f,1,1\n").find("'?' is not a number"), std::string::npos);
  EXPECT_NE(parse("\x7f").find("got '?'"), std::string::npos);
  EXPECT_NE(parse("r_mm,R,G,B\n0,0,1,1\n1,0,1,1\n").find("0 everywhere"), std::string::npos);
  // A cone R = 1 - r: total pi / 3.
  const auto cone = profile::parse_csv("\xEF\xBB\xBF# cone\r\nr_mm,R,G,B\r\n0,1,1,1\r\n1,0,0,0\r\n", "r.csv");
  EXPECT_NEAR(cone[0]->total(), M_PI / 3, 1e-12);
  EXPECT_NEAR(cone[0]->hankel(1e-6), M_PI / 3, 1e-3);
  EXPECT_EQ(cone[0]->at(0.25), 0.75);
  EXPECT_EQ(cone[0]->at(2), 0);
}

}  // namespace
}  // namespace dermis
