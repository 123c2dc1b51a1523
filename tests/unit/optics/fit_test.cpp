// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "base/core/error.h"
#include "tissue/gaussians/fit.h"
#include "tissue/optics/presets.h"
#include "tissue/profile/dipole.h"
#include "tissue/profile/slab.h"
#include "tissue/profile/tabulated.h"
#include "truth.h"

namespace dermis {
namespace {

using gaussians::ChannelFit;
using profile::Dipole;

/// Hides the closed form, so that fits and transforms must go through R(r).
class RadialOnly final : public profile::RadialProfile {
 public:
  explicit RadialOnly(const optics::Medium& medium) : dipole_(medium) {}
  double at(double r) const override { return dipole_.at(r); }
  double inner_mm() const override { return dipole_.inner_mm(); }
  double outer_mm() const override { return dipole_.outer_mm(); }
  std::string name() const override { return "radial only"; }

 private:
  Dipole dipole_;
};

TEST(Dipole, TransformAndTotalAgreeWithTheRadialForm) {
  for (const char* name : {"skin1", "marble", "ketchup"}) {
    const auto medium = optics::find_material(name)->medium();
    for (const auto& one : medium) {
      const Dipole dipole(one);
      const profile::BetterDipole better(one);
      const RadialOnly radial(one);
      for (const double k : {0.0, 0.1, 1.0, 5.0})
        EXPECT_NEAR(radial.hankel(k / dipole.outer_mm()), dipole.hankel(k / dipole.outer_mm()),
                    1e-3 * dipole.total());
      for (const double r : {0.3, 1.0, 3.0, 10.0}) {
        const double radius = r * dipole.inner_mm();
        EXPECT_NEAR(inverse_hankel(dipole, radius) / dipole.at(radius), 1, 1e-5) << name << r;
        EXPECT_NEAR(inverse_hankel(better, radius) / better.at(radius), 1, 1e-5) << name << r;
      }
      EXPECT_NEAR(dipole.within(dipole.quantile(0.5)), 0.5 * dipole.total(), 1e-3 * dipole.total());
    }
  }
}

TEST(Dipole, TotalsOfTheBetterDipole) {
  struct Row {
    double albedo, jensen, better;
  };
  for (const Row& row :
       {Row{0.5, 0.07382, 0.02489}, Row{0.8, 0.19078, 0.11329}, Row{0.9, 0.28445, 0.21339},
        Row{0.95, 0.38265, 0.33177}, Row{0.99, 0.61277, 0.60447}, Row{0.999, 0.84582, 0.85099}}) {
    const optics::Medium medium{
        .sigma_a_per_mm = 1 - row.albedo, .sigma_s_per_mm = row.albedo, .g = 0, .eta = 1.4};
    EXPECT_NEAR(Dipole(medium).total(), row.jensen, 1e-4 * row.jensen + 5e-6) << row.albedo;
    EXPECT_NEAR(profile::BetterDipole(medium).total(), row.better, 1e-4 * row.better + 5e-6) << row.albedo;
  }
}

TEST(Fit, EveryMaterialAsGoodAsAnIndependentFitter) {
  double worst_four = 0, best_four = 100;
  for (const auto& row : truth::fit_rows) {
    const Dipole dipole(optics::find_material(row.material)->medium()[row.channel]);
    for (int k = 2; k <= 6; ++k) {
      const ChannelFit fit = gaussians::fit_channel(dipole, k);
      const double expected = row.error_percent[k - 2];
      EXPECT_LE(fit.error_percent, expected * (1 + 1e-3) + 6e-5) << row.material << row.channel << " k " << k;
      EXPECT_GE(fit.error_percent, expected * (1 - 1e-2) - 1e-4)
          << row.material << row.channel << " k " << k << ": better than optimal";
      if (k == 4 && std::string(row.material) != "ketchup")
        worst_four = std::max(worst_four, fit.error_percent),
        best_four = std::min(best_four, fit.error_percent);
    }
  }
  EXPECT_NEAR(worst_four, 1.503, 2e-3);
  EXPECT_NEAR(best_four, 0.0794, 2e-4);
}

TEST(Fit, RadialAndSpectralFormsGiveTheSameSum) {
  const optics::Medium medium = optics::find_material("skin2")->medium()[1];
  const ChannelFit spectral = gaussians::fit_channel(Dipole(medium), 4),
                   radial = gaussians::fit_channel(RadialOnly(medium), 4);
  EXPECT_NEAR(radial.error_percent, spectral.error_percent, 1e-4 * spectral.error_percent);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(radial.terms[i].variance_mm2 / spectral.terms[i].variance_mm2, 1, 1e-3);
    EXPECT_NEAR(radial.terms[i].weight / spectral.terms[i].weight, 1, 1e-3);
  }
}

// GPU Gems 3: 0.070 G(0.036) + 0.18 G(0.14) + 0.21 G(0.91) + 0.29 G(7.0), printed to two digits.
TEST(Fit, ReproducesThePublishedMarble) {
  const ChannelFit fit = gaussians::fit_channel(Dipole(optics::find_material("marble")->medium()[1]), 4);
  ASSERT_EQ(fit.terms.size(), 4u);
  const double weight[] = {0.070, 0.18, 0.21, 0.29}, variance[] = {0.036, 0.14, 0.91, 7.0};
  const double weight_unit[] = {0.001, 0.01, 0.01, 0.01}, variance_unit[] = {0.001, 0.01, 0.01, 0.1};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(fit.terms[i].weight, weight[i], 0.7 * weight_unit[i]) << i;
    EXPECT_NEAR(fit.terms[i].variance_mm2, variance[i], 0.7 * variance_unit[i]) << i;
  }
  const gaussians::Term published[] = {{0.036, 0.070}, {0.14, 0.18}, {0.91, 0.21}, {7.0, 0.29}};
  EXPECT_NEAR(error_percent(Dipole(optics::find_material("marble")->medium()[1]), published), 1.540, 2e-3);
}

TEST(Fit, SharedVariancesAreSortedNormalisedAndPositive) {
  for (const char* name : {"skin1", "skin2", "cream"}) {
    const auto medium = optics::find_material(name)->medium();
    std::array<profile::ProfilePtr, 3> profiles;
    for (int c = 0; c < 3; ++c) profiles[c] = std::make_shared<Dipole>(medium[c]);

    double before = 1e9;
    for (int k = 1; k <= 8; ++k) {
      const auto sum = gaussians::fit_shared(profiles, k, name);
      double error2 = 0;
      for (int c = 0; c < 3; ++c) {
        double total = 0;
        for (std::size_t i = 0; i < sum.terms.size(); ++i) {
          EXPECT_GE(sum.terms[i].weight[c], 0);
          EXPECT_GT(sum.terms[i].variance_mm2, i > 0 ? sum.terms[i - 1].variance_mm2 : 0);
          total += sum.terms[i].weight[c];
        }
        EXPECT_NEAR(total, 1, 1e-9);
        error2 += sum.error_percent[c] * sum.error_percent[c];
      }

      EXPECT_LT(error2, before) << name << k;
      before = error2;
      EXPECT_LT(std::sqrt(error2), k >= 6 ? 1.5 : 100) << name;
    }
  }
}

// The measure of the plane gives the tail away, which holds little of R but much of the light in red.
TEST(Fit, EnergyKeepsTheTail) {
  const auto medium = optics::find_material("skin2")->medium();
  std::array<profile::ProfilePtr, 3> dipoles;
  for (std::size_t c = 0; c < 3; ++c) dipoles[c] = std::make_shared<Dipole>(medium[c]);
  const auto plane = gaussians::fit_shared(dipoles, 6, "plane"),
             energy = gaussians::fit_shared(dipoles, 6, "energy", gaussians::Measure::energy);

  const auto beyond = [](const ScatterProfile& sum, double radius_mm) {
    double light = 0;
    for (const Gaussian& term : sum.terms)
      light += term.weight[0] * std::exp(-radius_mm * radius_mm / (2 * term.variance_mm2));
    return light;
  };
  for (const double radius_mm : {5.0, 10.0, 15.0}) {
    const double truth = 1 - dipoles[0]->within(radius_mm) / dipoles[0]->total();
    EXPECT_LT(std::abs(beyond(energy, radius_mm) - truth), 0.5 * std::abs(beyond(plane, radius_mm) - truth))
        << radius_mm;
    EXPECT_NEAR(beyond(energy, radius_mm), truth, 0.003) << radius_mm;
  }
}

TEST(Fit, FindsASumThatIsOneAlready) {
  std::string csv = "r_mm,R,G,B\n";
  const gaussians::Term truth[] = {{0.05, 0.3}, {1.5, 0.5}};
  for (double r = 0; r < 12; r += 0.004) {
    const double value = gaussians::evaluate(truth, r);
    csv += fmt::format("{},{},{},{}\n", r, value, value, value);
  }
  const auto fit = gaussians::fit_channel(*profile::parse_csv(csv, "two.csv")[0], 2);
  ASSERT_EQ(fit.terms.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(fit.terms[i].variance_mm2 / truth[i].variance_mm2, 1, 2e-3);
    EXPECT_NEAR(fit.terms[i].weight / truth[i].weight, 1, 2e-3);
  }
  EXPECT_LT(fit.error_percent, 0.1);
}

/// The best single Gaussian of a table by fine quadrature: {variance in mm^2, error in per cent}.
std::array<double, 2> best_gaussian(const profile::RadialProfile& table, double end_mm) {
  constexpr int count = 20'000;
  const double step = 6 * end_mm / count;
  double square = 0;
  std::vector<double> radius, value;
  for (int i = 0; i < count; ++i) {  // midpoints: a jump at the end falls between two
    radius.push_back((i + 0.5) * step);
    value.push_back(table.at(radius.back()));
    square += radius[i] * value[i] * value[i] * step;
  }

  const auto explained = [&](double v) {
    double product = 0;
    for (int i = 0; i < count; ++i)
      product += radius[i] * value[i] * std::exp(-radius[i] * radius[i] / (2 * v)) * step;
    return product * product / (v / 2) / square;  // Int r G^2 dr, G = e^{-r^2/2v}, is v/2
  };

  // Narrow ln(variance) down to the best by golden sections.
  double low = std::log(1e-2 * end_mm * end_mm), high = std::log(4 * end_mm * end_mm);
  for (int i = 0; i < 40; ++i) {
    const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
    (explained(std::exp(a)) < explained(std::exp(b)) ? low : high) =
        explained(std::exp(a)) < explained(std::exp(b)) ? a : b;
  }

  return {std::exp(low), 100 * std::sqrt(1 - explained(std::exp(low)))};
}

// Tables are straight between their rows and jump at their end; a grid of its own would see neither.
TEST(Fit, TablesAreIntegratedFromRowToRow) {
  std::string decay = "r_mm,R,G,B\n";
  for (int i = 0; i < 16; ++i)
    decay += fmt::format("{0},{1},{1},{1}\n", i / 10.0, 0.05 * std::exp(-i / 10.0));

  struct Table {
    std::string csv;
    double end_mm;
  };
  for (const Table& table : {Table{decay, 1.5}, Table{"r_mm,R,G,B\n0,.3,.3,.3\n1,.3,.3,.3\n", 1},
                             Table{"r_mm,R,G,B\n0,0,0,0\n1,0,0,0\n1.03,2,2,2\n1.06,0,0,0\n", 1.06}}) {
    const auto profile = profile::parse_csv(table.csv, "table.csv")[0];
    const ChannelFit fit = gaussians::fit_channel(*profile, 1);
    const auto [variance, error] = best_gaussian(*profile, table.end_mm);

    ASSERT_EQ(fit.terms.size(), 1u);
    EXPECT_NEAR(fit.error_percent, error, 2e-3 * error) << table.csv;
    EXPECT_NEAR(fit.terms[0].variance_mm2 / variance, 1, 5e-3) << table.csv;
    EXPECT_NEAR(gaussians::error_percent(*profile, fit.terms), fit.error_percent, 1e-9);
    EXPECT_NEAR(profile->hankel(0) / profile->total(), 1, 1e-3);
  }

  // A box of radius 1: (1 - e^{-t})^2 / t is largest for t = 1/2v = 1.2564
  const auto box =
      gaussians::fit_channel(*profile::parse_csv("r_mm,R,G,B\n0,.3,.3,.3\n1,.3,.3,.3\n", "box.csv")[0], 1);
  EXPECT_NEAR(box.terms[0].variance_mm2, 0.39796, 1e-4);
  EXPECT_NEAR(box.error_percent, 43.066, 5e-3);
}

// Without absorption a thick slab is a half-space, however thick.
TEST(Fit, ThickSlabsOfClearMediaStayFinite) {
  const auto dipole =
      gaussians::fit_channel(Dipole(optics::Medium{.sigma_a_per_mm = 0, .sigma_s_per_mm = 1}), 6);
  for (const double thickness_mm : {1e5, 1e6}) {
    const profile::LayeredProfile slab({{0, 1, 1.4, thickness_mm}}, profile::SlabProfile::Side::reflected);
    EXPECT_NEAR(gaussians::fit_channel(slab, 6).error_percent, dipole.error_percent, 1e-3) << thickness_mm;
  }
}

/// A profile that says what it likes.
class MadeUp final : public profile::RadialProfile {
 public:
  double at(double) const override { return NAN; }
  double hankel(double k) const override { return k > 0 ? NAN : 0.5; }
  double inner_mm() const override { return 1; }
  double outer_mm() const override { return 1; }
  bool hankel_is_exact() const override { return true; }
  std::string name() const override { return "made up"; }
};

TEST(Fit, WhatIsNotFiniteIsRefused) { EXPECT_THROW(gaussians::fit_channel(MadeUp(), 2), InputError); }

TEST(Fit, BlackProfilesAreRefused) {
  const Dipole black(optics::Medium{.sigma_a_per_mm = 1, .sigma_s_per_mm = 0});
  EXPECT_THROW(gaussians::fit_channel(black, 4), InputError);
}

}  // namespace
}  // namespace dermis
