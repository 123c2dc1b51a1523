// SPDX-License-Identifier: MIT
// What a program outside gets of a profile beside its terms: R(r) of the model, its noise, R(r) of the fit,
// the profile file, and the refusal of profiles that no picture can be made with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>

#include "dermis/error.h"
#include "dermis/profile.h"
#include "support/files.h"
#include "support/thrown.h"
#include "tissue/optics/presets.h"
#include "tissue/profile/dipole.h"
#include "tissue/profile/monte_carlo.h"
#include "tissue/profile/spectral.h"

namespace dermis {
namespace {

using std::numbers::pi;
constexpr std::array<std::size_t, 3> channels{0, 1, 2};

/// Integrates f(r) dr over the radii of a table by the trapezoid rule in log r.
double over_table(const ProfileTable& table, const std::function<double(std::size_t)>& f_per_mm) {
  const std::vector<double>& r = table.r_mm;
  double sum = 0;
  for (std::size_t i = 0; i + 1 < r.size(); ++i)
    sum += 0.5 * std::log(r[i + 1] / r[i]) * (r[i] * f_per_mm(i) + r[i + 1] * f_per_mm(i + 1));
  return sum;
}

double light_in_table(const ProfileTable& table, std::size_t c) {
  return over_table(table,
                    [&](std::size_t i) { return 2 * pi * table.r_mm[i] * table.reflectance_per_mm2[i][c]; });
}

ScatterProfile skin_by_photons(std::uint64_t photons, std::uint64_t seed = 1) {
  return profile_of_preset(
      "skin1", {.gaussians = 4, .model = ProfileModel::monte_carlo, .photons = photons, .seed = seed});
}

// Frames take the presets by name, without a fit: they are kept to six digits.
TEST(PublicProfile, PresetsAreProfilesByName) {
  for (const std::string_view name : optics::preset_names())
    EXPECT_EQ(load_profile(std::string(name)).name, name);

  for (const char* name : {"marble", "skin1"}) {
    const ScatterProfile kept = load_profile(name), made = profile_of_preset(name);
    ASSERT_EQ(kept.terms.size(), made.terms.size()) << name;
    for (std::size_t k = 0; k < made.terms.size(); ++k) {
      EXPECT_NEAR(kept.terms[k].variance_mm2 / made.terms[k].variance_mm2, 1, 0.01) << name;
      for (const std::size_t c : channels)
        EXPECT_NEAR(kept.terms[k].weight[c], made.terms[k].weight[c], 1e-3) << name;
    }
    ASSERT_TRUE(kept.medium && kept.shape) << name;
    EXPECT_NEAR(kept.medium->sigma_s_per_mm[0], made.medium->sigma_s_per_mm[0], 1e-5) << name;
    EXPECT_NEAR(kept.shape->curvature_mm[0] / made.shape->curvature_mm[0], 1, 0.01) << name;
  }
}

// Simpson's rule in log r. What it leaves out is r0^2 / 2v within r0 and exp(-r1^2 / 2v) beyond r1, 1e-8 at
// most here.
TEST(PublicProfile, TheFitReflectsItsTotal) {
  const ScatterProfile skin = profile_of_preset("skin1", {.model = ProfileModel::dipole});
  const double from = std::log(1e-4 * std::sqrt(skin.terms.front().variance_mm2)),
               to = std::log(8 * std::sqrt(skin.terms.back().variance_mm2));
  constexpr int steps = 2000;
  std::array<double, 3> light{};
  for (int i = 0; i <= steps; ++i) {
    const double r = std::exp(from + (to - from) * i / steps), weight = i % steps == 0 ? 1 : 2 + 2 * (i % 2);
    const std::array<double, 3> here = reflectance(skin, r);
    for (const std::size_t c : channels)
      light[c] += weight * (to - from) / (3 * steps) * 2 * pi * r * r * here[c];
  }
  for (const std::size_t c : channels) EXPECT_NEAR(light[c] / skin.total_reflectance[c], 1, 1e-6) << c;
}

// The table leaves out 1e-3 of the light at most; the trapezoid rule over 24 radii per decade adds less. R(r)
// of Monte-Carlo is a line in log-log between rings, of which there are 16 per decade: a power law of
// exponent p is off by (p h)^2 / 24 over a ring of h = 0.14, 2e-3 for p = 1.5.
TEST(PublicProfile, TheTableHoldsTheModelsLight) {
  for (const ProfileModel model : {ProfileModel::dipole, ProfileModel::beam, ProfileModel::monte_carlo}) {
    const ScatterProfile skin =
        profile_of_preset("skin2", {.gaussians = 2, .model = model, .photons = 20'000});
    const double bound = model == ProfileModel::monte_carlo ? 1e-2 : 2e-3;
    const ProfileTable table = model_table(skin);
    ASSERT_EQ(table.r_mm.size(), table.reflectance_per_mm2.size());
    ASSERT_EQ(table.r_mm.size(), table.standard_error_per_mm2.size());
    for (const std::size_t c : channels)
      EXPECT_NEAR(light_in_table(table, c) / skin.model_total[c], 1, bound) << c << skin.model;
  }
}

TEST(PublicProfile, TheTableIsTheModel) {
  const ScatterProfile skin = profile_of_preset("skin1", {.gaussians = 2, .model = ProfileModel::dipole});
  const ProfileTable table = model_table(skin);
  const optics::RgbMedium medium = optics::find_material("skin1")->medium();
  ASSERT_GT(table.r_mm.size(), 40u);
  for (const std::size_t c : channels) {
    const profile::Dipole dipole(medium[c]);
    for (std::size_t i = 0; i < table.r_mm.size(); ++i) {
      EXPECT_EQ(table.reflectance_per_mm2[i][c], dipole.at(table.r_mm[i]));
      EXPECT_EQ(table.standard_error_per_mm2[i][c], 0);
    }
    EXPECT_EQ(skin.noise_percent[c], 0);
  }
  EXPECT_EQ(skin.model_reason, "");
  EXPECT_NE(profile_of_preset("marble", {.gaussians = 2}).model_reason, "");
}

// The error of the fit is 100 sqrt( Int r (R - S)^2 dr / Int r R^2 dr ), with weights before they were
// divided by their sum. Those weights are the least squares, so S is the multiple of the public fit that is
// nearest to R: its error follows from the three integrals of R^2, R S and S^2.
TEST(PublicProfile, TableAndFitGiveTheErrorOfTheFit) {
  const ScatterProfile skin = profile_of_preset("skin1", {.gaussians = 3, .model = ProfileModel::dipole});
  const ProfileTable table = model_table(skin);
  for (const std::size_t c : channels) {
    const auto model = [&](std::size_t i) { return table.reflectance_per_mm2[i][c]; };
    const auto fit = [&](std::size_t i) { return reflectance(skin, table.r_mm[i])[c]; };
    const auto product = [&](const auto& a, const auto& b) {
      return over_table(table, [&](std::size_t i) { return table.r_mm[i] * a(i) * b(i); });
    };
    const double cosine = product(model, fit) / std::sqrt(product(model, model) * product(fit, fit));
    ASSERT_GT(skin.error_percent[c], 1);
    EXPECT_NEAR(100 * std::sqrt(1 - cosine * cosine) / skin.error_percent[c], 1, 0.02) << c;
  }
}

// Sixteen times the photons have a quarter of the noise. It is estimated from 64 batches: a ring's variance
// to 18 %, the noise over all rings to about 4 %, the ratio of two to 6 %.
TEST(PublicProfile, NoiseShrinksAsTheRootOfThePhotons) {
  const ScatterProfile few = skin_by_photons(8'000), many = skin_by_photons(128'000);
  for (const std::size_t c : channels) {
    EXPECT_GT(few.noise_percent[c], 0.5);
    EXPECT_NEAR(few.noise_percent[c] / many.noise_percent[c], 4, 0.7) << c;
  }

  const ProfileTable of_few = model_table(few), of_many = model_table(many);
  // The errors of the table, over the radii that both have.
  double ratio = 0;
  int count = 0;
  for (std::size_t i = 0; i < of_few.r_mm.size(); ++i) {
    const auto same = std::ranges::find(of_many.r_mm, of_few.r_mm[i]);
    if (same == of_many.r_mm.end()) continue;
    const auto j = static_cast<std::size_t>(same - of_many.r_mm.begin());
    const double error = of_many.standard_error_per_mm2[j][1];
    if (!(error > 0)) continue;
    ratio += of_few.standard_error_per_mm2[i][1] / error;
    ++count;
  }
  ASSERT_GT(count, 30);
  EXPECT_NEAR(ratio / count, 4, 0.7);
}

// The standard errors are what runs with other seeds differ by: over 24 seeds and the rings between 10 and
// 90 % of the light (about 20 a channel), the mean of the squared ratio is 1 to about 4 %.
TEST(PublicProfile, StandardErrorsAreWhatSeedsDifferBy) {
  constexpr int seeds = 24;
  const optics::RgbMedium medium = optics::find_material("skin1")->medium();
  double ratio = 0;
  int count = 0;
  for (const std::size_t c : channels) {
    std::vector<std::unique_ptr<profile::MonteCarloProfile>> runs;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
      runs.push_back(std::make_unique<profile::MonteCarloProfile>(
          profile::scene_of(medium[c]),
          profile::MonteCarloOptions{.photons = 4'000, .seed = seed, .cache = {}}));

    const double near_mm = runs[0]->quantile(0.1), far_mm = runs[0]->quantile(0.9);
    for (double r = near_mm; r < far_mm; r *= 1.16, ++count) {
      double sum = 0, sum2 = 0, error2 = 0;
      for (const auto& run : runs) {
        sum += run->at(r) / seeds;
        error2 += run->standard_error_at(r) * run->standard_error_at(r) / seeds;
      }
      for (const auto& run : runs) sum2 += (run->at(r) - sum) * (run->at(r) - sum) / (seeds - 1);
      ratio += sum2 / error2;
    }
  }
  ASSERT_GT(count, 40);
  EXPECT_NEAR(ratio / count, 1, 0.15);
}

TEST(PublicProfile, ErrorsOfWavelengthsAddAsSquares) {
  const auto run = [](std::uint64_t seed) {
    return std::make_shared<profile::MonteCarloProfile>(
        profile::scene_of(optics::Medium{0.1, 1, 0, 1.4}),
        profile::MonteCarloOptions{.photons = 2'000, .seed = seed, .cache = {}});
  };
  const auto a = run(1), b = run(2);
  const double total = 3 * a->total() - b->total();
  const profile::WeightedProfile both({{3, a}, {-1, b}}, total, "both", "test");
  for (const double r : {0.1, 0.5, 2.0}) {
    ASSERT_GT(a->standard_error_at(r), 0);
    EXPECT_NEAR(both.standard_error_at(r), std::hypot(3 * a->standard_error_at(r), b->standard_error_at(r)),
                1e-12);
  }
}

TEST(PublicProfile, FilesAreReadBack) {
  const tests::TempFolder folder;
  const std::string path = (folder.path() / "skin.json").string();
  const ScatterProfile made = profile_of_preset("skin1", {.model = ProfileModel::dipole});
  write_profile(made, path);
  const ScatterProfile read = load_profile(path);
  EXPECT_EQ(read.name, made.name);
  EXPECT_EQ(read.model, made.model);
  EXPECT_EQ(read.terms, made.terms);
  EXPECT_EQ(read.error_percent, made.error_percent);
  EXPECT_EQ(read.total_reflectance, made.total_reflectance);
  EXPECT_EQ(read.mean_free_path_mm, made.mean_free_path_mm);
  EXPECT_EQ(read.diffuse_mean_free_path_mm, made.diffuse_mean_free_path_mm);
  EXPECT_EQ(read.medium, made.medium);
  EXPECT_EQ(read.medium->eta, 1.3);
  EXPECT_EQ(read.shape, made.shape);
  EXPECT_EQ(tests::thrown<InputError>([&] { model_table(read); }),
            "profile 'skin1' has no curves of a model: it was read, or put together by hand");
  check_profile(read);

  EXPECT_EQ(load_profile("skin").terms.size(), 6u);
  EXPECT_NE(tests::thrown<InputError>([] { load_profile("no-such-profile"); }).find("there are: skin"),
            std::string::npos);
  tests::write_text(path, R"({"variances_mm2": [1], "weights": [[1, 2, 1]]})");
  EXPECT_NE(tests::thrown<InputError>([&] { load_profile(path); }).find("weights of green sum to 2"),
            std::string::npos);
  EXPECT_EQ(load_profile(path, true).terms[0].weight[1], 1);
}

TEST(PublicProfile, WhatNoPictureCanBeMadeWithIsRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = HUGE_VAL;
  const ScatterProfile good{
      .name = "mine", .model = {}, .terms = {{0.1, {0.25, 0.5, 1}}, {2, {0.75, 0.5, 0}}}};
  check_profile(good);

  struct Case {
    std::function<void(ScatterProfile&)> spoil;
    std::string message;
  };
  const std::vector<Case> cases{
      {[](auto& p) { p.terms.clear(); }, "terms must be 1 to 8, there are 0"},
      {[](auto& p) { p.terms.resize(1'000'000); }, "terms must be 1 to 8, there are 1000000"},
      {[](auto& p) { p.terms[0].variance_mm2 = 0; },
       "terms[0].variance_mm2 must be > 0 mm^2 and finite, got 0"},
      {[](auto& p) { p.terms[0].variance_mm2 = -1; },
       "terms[0].variance_mm2 must be > 0 mm^2 and finite, got -1"},
      {[&](auto& p) { p.terms[1].variance_mm2 = nan; },
       "terms[1].variance_mm2 must be > 0 mm^2 and finite, got nan"},
      {[&](auto& p) { p.terms[1].variance_mm2 = inf; },
       "terms[1].variance_mm2 must be > 0 mm^2 and finite, got inf"},
      {[](auto& p) { p.terms[1].variance_mm2 = 0.1; }, "variances of terms must rise, but 0.1 follows 0.1"},
      {[](auto& p) { p.terms[0].variance_mm2 = 3; }, "variances of terms must rise, but 2 follows 3"},
      {[](auto& p) { p.terms[1].weight[2] = -0.5; },
       "terms[1].weight of blue must be >= 0 and finite, got -0.5"},
      {[&](auto& p) { p.terms[0].weight[0] = nan; },
       "terms[0].weight of red must be >= 0 and finite, got nan"},
      {[](auto& p) { p.terms[0].weight[1] = 0.502; },
       "weights of green must sum to 1 within 0.001, they sum to 1.002"},
      {[](auto& p) { p.total_reflectance[0] = 1.5; }, "total_reflectance of red must be 0 to 1, got 1.5"},
      {[&](auto& p) { p.total_reflectance[2] = nan; }, "total_reflectance of blue must be 0 to 1, got nan"},
      {[&](auto& p) { p.error_percent[1] = inf; }, "error_percent of green must be >= 0 and finite, got inf"},
      {[](auto& p) { p.mean_free_path_mm[0] = -1; },
       "mean_free_path_mm of red must be >= 0 and finite, got -1"},
      {[&](auto& p) { p.diffuse_mean_free_path_mm[0] = nan; },
       "diffuse_mean_free_path_mm of red must be >= 0 and finite, got nan"},
      {[](auto& p) { p.shape.emplace(); }, "shape.front_mm must be 1e-12 to 1000000, got 0"},
      {[](auto& p) {
         p.shape.emplace();
         p.shape->front_mm = {1, 1, 1};
       },
       "shape needs the medium that it is of: medium is not given"},
  };
  for (const Case& bad : cases) {
    ScatterProfile profile = good;
    bad.spoil(profile);
    const std::string expected = "profile 'mine': " + bad.message;
    EXPECT_EQ(tests::thrown<InputError>([&] { check_profile(profile); }), expected);
    EXPECT_EQ(tests::thrown<InputError>([&] { reflectance(profile, 1); }), expected);
    EXPECT_EQ(tests::thrown<InputError>([&] { write_profile(profile, "/no/such/folder/p.json"); }), expected);
  }

  for (const double r_mm : {-1.0, nan})
    EXPECT_NE(tests::thrown<InputError>([&] { reflectance(good, r_mm); }).find("r_mm must be >= 0, got"),
              std::string::npos);
  EXPECT_EQ(reflectance(good, inf), (std::array<double, 3>{}));
}

}  // namespace
}  // namespace dermis
