// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

#include "base/core/error.h"
#include "base/settings/check.h"
#include "support/assets.h"
#include "support/half_space.h"
#include "tissue/optics/fresnel.h"
#include "tissue/optics/observer.h"
#include "tissue/optics/radiative.h"
#include "tissue/optics/skin.h"
#include "tissue/profile/monte_carlo.h"
#include "tissue/profile/slab.h"

namespace dermis {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Radiative, ChandrasekharH) {
  struct Row {
    double a, h, normal, diffuse;
  };
  for (const Row& row : {Row{.2, 1.078645, .035231, .046265}, Row{.5, 1.251260, .115226, .146544},
                         Row{.8, 1.598220, .285255, .341867}, Row{.9, 1.850099, .414947, .478024},
                         Row{.95, 2.077124, .535541, .596669}, Row{.99, 2.472793, .752721, .794564},
                         Row{.999, 2.756073, .912845, .929713}, Row{1, 2.907811, 1, 1}}) {
    EXPECT_NEAR(optics::chandrasekhar_h(row.a, 1), row.h, 1e-5) << row.a;
    EXPECT_NEAR(optics::exact_reflectance_perpendicular(row.a), row.normal, 1e-5) << row.a;
    EXPECT_NEAR(optics::exact_reflectance_diffuse(row.a), row.diffuse, 1e-5) << row.a;
    if (row.a < 1) {  // the same half-space by adding and doubling
      EXPECT_NEAR(optics::adding_doubling({{1 - row.a, row.a, 1, infinite}}).reflectance, row.normal, 1e-6)
          << row.a;
    }
  }
}

TEST(Radiative, AddingDoublingAgainstMonteCarlo) {
  struct Row {
    double albedo, total;
  };  // n = 1.4, per flux sent; 2e6 photons
  const double into = 1 - optics::fresnel(1, 1 / 1.4);
  for (const Row& row : {Row{.5, .05234}, Row{.8, .15300}, Row{.9, .25088}, Row{.95, .35900},
                         Row{.99, .60359}, Row{.999, .83023}})
    EXPECT_NEAR(into * optics::adding_doubling({{1 - row.albedo, row.albedo, 1.4, infinite}}).reflectance,
                row.total, 4e-4)
        << row.albedo;
  const optics::Totals slab = optics::adding_doubling({{.1, 1, 1.4, 4}});
  EXPECT_NEAR(into * slab.reflectance, .26404, 4e-4);
  EXPECT_NEAR(into * slab.transmittance, .08188 + .01158, 4e-4);
  const optics::Totals clear = optics::adding_doubling({{0, 1, 1.4, 3}});
  EXPECT_NEAR(clear.reflectance + clear.transmittance, 1, 1e-6);
  EXPECT_THROW(optics::adding_doubling({{.1, 1, 1.4, 1}, {.1, 1, 1.3, 1}}), InputError);
}

// What 64 directions converge to (48 agree to 5e-6): the accuracy that radiative.h states.
TEST(Radiative, AsExactAsStated) {
  struct Row {
    optics::Layers layers;
    double reflectance, transmittance;
  };
  for (const Row& row :
       {Row{{{.5, .5, 1.4, infinite}}, .053797, 0}, Row{{{.1, .9, 1.4, infinite}}, .257759, 0},
        Row{{{.01, .99, 1.4, infinite}}, .620838, 0}, Row{{{.05, .95, 1.3, 1}}, .261938, .603778},
        Row{{{.1, 1, 1.4, 4}}, .271535, .096408}, Row{{{.1, 1, 1.4, 1}}, .216967, .521081},
        Row{{{.5, 4, 1.4, .25}, {.05, 2, 1.4, infinite}}, .320177, 0}}) {
    const optics::Totals fine = optics::adding_doubling(row.layers),
                         coarse = optics::adding_doubling_coarse(row.layers);

    EXPECT_NEAR(fine.reflectance, row.reflectance, 3e-4);
    EXPECT_NEAR(fine.transmittance, row.transmittance, 3e-4);
    EXPECT_NEAR(coarse.reflectance, row.reflectance, 2e-3);
    EXPECT_NEAR(coarse.transmittance, row.transmittance, 2e-3);
  }

  // Giovanelli 1955, isotropic, n = 1.5, with what the surface reflects
  EXPECT_NEAR(.04 + .96 * optics::adding_doubling({{1, 9, 1.5, infinite}}).reflectance, .2600, 3e-4);
}

struct TypeRow {
  const char* name;
  SpectralSkin skin;
  double nm, monte_carlo, multipole;
};
const TypeRow types[] = {
    {"Caucasian", {.005, .7, .005}, 450, .34276, .35521},
    {"Caucasian", {.005, .7, .005}, 550, .38725, .38925},
    {"Caucasian", {.005, .7, .005}, 650, .52010, .52088},
    {"Asian", {.15, 0, .01}, 450, .04608, .06393},
    {"Asian", {.15, 0, .01}, 550, .07534, .09884},
    {"Asian", {.15, 0, .01}, 650, .14357, .16853},
    {"African", {.5, .7, .05}, 450, .01256, .01767},
    {"African", {.5, .7, .05}, 550, .01708, .02391},
    {"African", {.5, .7, .05}, 650, .02386, .03340},
};

// The three skins of the 2006 sketch: Monte-Carlo of 1e6 photons (+-0.0005) and closed forms, both of
// independent programs.
TEST(Skin, TotalsOfTheSketch) {
  for (const TypeRow& row : types) {
    const optics::Layers layers = optics::skin_layers(row.skin, row.nm);
    EXPECT_NEAR(profile::LayeredProfile(layers, profile::SlabProfile::Side::reflected).total(), row.multipole,
                1e-4 * row.multipole + 5e-6)
        << row.name << row.nm;
    EXPECT_NEAR(optics::adding_doubling(layers).reflectance, row.monte_carlo, 0.002) << row.name << row.nm;
    const auto photons =
        profile::monte_carlo(profile::scene_of(layers), {.photons = 60'000, .seed = 4, .cache = {}});
    EXPECT_NEAR(photons->reflected_total, row.monte_carlo, 0.002) << row.name << row.nm;
  }
}

TEST(Skin, Chromophores) {
  struct Row {
    double nm, em, pm, base, oxy, deoxy, scattering;
  };
  for (const Row& row : {Row{450, 96.4598, 72.3833, .12192, 33.6370, 55.3113, 9.2091},
                         Row{500, 67.9163, 43.8824, .07022, 11.2092, 11.1713, 7.2760},
                         Row{550, 49.4466, 27.9046, .04593, 23.0344, 28.6013, 6.0823},
                         Row{600, 37.0084, 18.4578, .03452, 1.7136, 7.8594, 5.3058},
                         Row{650, 28.3493, 12.6200, .02915, .1971, 2.0081, 4.7778},
                         Row{700, 22.1497, 8.8753, .02663, .1553, .9608, 4.4043}}) {
    EXPECT_NEAR(optics::eumelanin_per_mm(row.nm) / row.em, 1, 1e-5);
    EXPECT_NEAR(optics::pheomelanin_per_mm(row.nm) / row.pm, 1, 1e-5);
    EXPECT_NEAR(optics::baseline_per_mm(row.nm) / row.base, 1, 1e-3);
    EXPECT_NEAR(optics::oxyhaemoglobin_per_mm(row.nm), row.oxy, 1e-4);
    EXPECT_NEAR(optics::deoxyhaemoglobin_per_mm(row.nm), row.deoxy, 1e-4);
    EXPECT_NEAR(optics::skin_scattering_per_mm(row.nm) / row.scattering, 1, 1e-5);
  }
}

double total(const SpectralSkin& skin, double nm) {
  return optics::adding_doubling(optics::skin_layers(skin, nm)).reflectance;
}

TEST(Skin, LightestToDarkestIsOrderedAtEveryWavelength) {
  for (const double nm : optics::wavelengths_nm()) {
    double before = 2;
    for (const double melanin : {0.0, 0.01, 0.05, 0.15, 0.5}) {
      const double now = total({.melanin = melanin}, nm);
      EXPECT_LT(now, before) << nm << " nm, melanin " << melanin;
      before = now;
    }
    before = 2;
    for (const double blood : {0.0, 0.005, 0.02, 0.1}) {
      const double now = total({.haemoglobin = blood}, nm);
      // At 700 nm and beyond oxygenated blood absorbs little more than the baseline
      EXPECT_LT(now, before) << nm << " nm, blood " << blood;
      before = now;
    }
  }
}

TEST(Skin, TheWOfHaemoglobin) {
  const SpectralSkin skin{.melanin = .01, .haemoglobin = .02, .oxygenation = .95};
  const double low1 = total(skin, 542), middle = total(skin, 560), low2 = total(skin, 576),
               after = total(skin, 600);
  EXPECT_LT(low1, middle - .01);
  EXPECT_LT(low2, middle - .01);
  EXPECT_GT(after, low2 + .1);
}

// Linear Rec.709 under D65 of a reflectance (0..1) given by wavelength [nm].
optics::Rgb linear_rgb(const std::function<double(double nm)>& reflectance) {
  optics::Rgb sum{};
  for (std::size_t i = 0; i < optics::wavelengths_nm().size(); ++i)
    for (int c = 0; c < 3; ++c)
      sum[c] += optics::rec709_weights()[i][c] * reflectance(optics::wavelengths_nm()[i]);
  return sum;
}

TEST(Skin, BlushingAndBlanchingChangeGreenAndBlueMost) {
  const auto colour = [](double blood) {
    const SpectralSkin skin{.melanin = .01, .haemoglobin = blood};
    return linear_rgb([&](double nm) { return total(skin, nm); });
  };
  const optics::Rgb normal = colour(.01), blush = colour(.05), blanch = colour(.001);
  for (int c = 0; c < 3; ++c) {
    EXPECT_LT(blush[c], normal[c]);
    EXPECT_GT(blanch[c], normal[c]);
  }
  EXPECT_LT(blush[1] / normal[1], blush[0] / normal[0] - .02);
  EXPECT_LT(normal[1] / blanch[1], normal[0] / blanch[0] - .02);
  EXPECT_GT(optics::lab_from_linear(blush).a, optics::lab_from_linear(normal).a);
  EXPECT_LT(optics::lab_from_linear(blanch).a, optics::lab_from_linear(normal).a);
}

TEST(Skin, RangesAreChecked) {
  EXPECT_THROW(check_ranges(SpectralSkin{.melanin = -.1}, "x"), InputError);
  EXPECT_THROW(check_ranges(SpectralSkin{.haemoglobin = .2}, "x"), InputError);
  EXPECT_THROW(check_ranges(SpectralSkin{.oxygenation = NAN}, "x"), InputError);
  EXPECT_NEAR(optics::entering_part(), 1 - .3 * .076812, 1e-6);
}

TEST(Observer, WhiteGreyAndLab) {
  const optics::Rgb white = linear_rgb([](double) { return 1.0; });
  for (const double value : white) EXPECT_NEAR(value, 1, 1e-12);
  const optics::Lab lab = optics::lab_from_linear({1, 1, 1});
  EXPECT_NEAR(lab.l, 100, 1e-9);
  EXPECT_NEAR(lab.a, 0, 1e-9);
  const optics::Lab red = optics::lab_from_linear({1, 0, 0});  // sRGB red: 53.24 80.09 67.20
  EXPECT_NEAR(red.l, 53.24, .05);
  EXPECT_NEAR(red.a, 80.09, .1);
  EXPECT_NEAR(red.b, 67.20, .1);
  const optics::Rgb back = optics::linear_from_lab(optics::lab_from_linear({.5, .3, .2}));
  EXPECT_NEAR(back[0], .5, 1e-4);
  EXPECT_NEAR(back[1], .3, 1e-4);
  EXPECT_NEAR(back[2], .2, 1e-4);
}

/// Rows of a CSV file beside the source tree, or none.
std::vector<std::vector<double>> csv_rows(const std::string& name) {
  std::ifstream in(tests::asset_cache() / ".." / "facts" / name);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'w') continue;
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(std::stod(field));
  }
  return rows;
}

TEST(Tables, AreTheSourcesOwn) {
  const auto blood = csv_rows("haemoglobin.csv"), cie = csv_rows("cie.csv");
  if (blood.empty() || cie.empty()) GTEST_SKIP() << "haemoglobin.csv and cie.csv are not at hand";

  for (const auto& row : blood) {
    if (row[0] < 380 || row[0] > 780) continue;
    const double scale = std::log(10.0) * 150 / 64500 / 10;
    EXPECT_NEAR(optics::oxyhaemoglobin_per_mm(row[0]) / (scale * row[1]), 1, 1e-12);
    EXPECT_NEAR(optics::deoxyhaemoglobin_per_mm(row[0]) / (scale * row[2]), 1, 1e-12);
  }

  ASSERT_EQ(optics::wavelengths_nm().size(), cie.size());
  double y = 0;
  for (std::size_t i = 0; i < cie.size(); ++i) {
    EXPECT_EQ(optics::wavelengths_nm()[i], cie[i][0]);
    y += cie[i][2] * cie[i][4];
  }

  // By the matrix of Rec.709 the weights are the observer's own three columns again, wavelength by
  // wavelength; x and z to the 2e-4 by which the white that the matrix is printed for differs from that of
  // the tables
  for (std::size_t i = 0; i < cie.size(); ++i) {
    const optics::Rgb w = optics::rec709_weights()[i];
    const double x = cie[i][1] * cie[i][4] / y, z = cie[i][3] * cie[i][4] / y;
    EXPECT_NEAR(.2126 * w[0] + .7152 * w[1] + .0722 * w[2], cie[i][2] * cie[i][4] / y, 2e-5) << cie[i][0];
    EXPECT_NEAR(.4124 * w[0] + .3576 * w[1] + .1805 * w[2], x, 2e-5 + 3e-4 * x) << cie[i][0] << " x";
    EXPECT_NEAR(.0193 * w[0] + .1192 * w[1] + .9505 * w[2], z, 2e-5 + 3e-4 * z) << cie[i][0] << " z";
  }
}

}  // namespace
}  // namespace dermis
