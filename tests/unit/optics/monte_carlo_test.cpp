// SPDX-License-Identifier: MIT
// Photons against numbers that others published, and against exact solutions. All comparisons at three standard errors, ours and theirs
// together.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/error.h"
#include "optics/fresnel.h"
#include "optics/presets.h"
#include "optics/quadrature.h"
#include "profile/beam.h"
#include "profile/monte_carlo.h"
#include "profile/single_rings.h"

namespace dermis {
namespace {

using optics::Medium;
using profile::MonteCarloOptions;
using profile::ScatterScene;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double from_cm = 0.1;

void expect_sigma(double value, double error, double truth, double truth_error, const std::string& what) {
  EXPECT_NEAR(value, truth, 3 * std::hypot(error, truth_error))
      << what << ": " << (value - truth) / std::hypot(error, truth_error) << " standard errors";
}

TEST(MonteCarlo, SlabOfVanDeHulst) {
  const ScatterScene slab{.layers = {{{10 * from_cm, 90 * from_cm, 0.75, 1}, 0.2}}};
  const auto r = profile::monte_carlo(slab, {.photons = 200'000, .seed = 7, .cache = {}});
  expect_sigma(r->reflected_total, r->reflected_total_error, .09739, 0, "Rd");
  expect_sigma(r->transmitted_total + r->ballistic, r->transmitted_total_error + std::sqrt(.135 * .865 / 2e5), .66096, 0, "Tt");
  EXPECT_NEAR(r->ballistic, std::exp(-2.0), 3 * std::sqrt(.135 * .865 / 2e5));
  EXPECT_NEAR(r->reflected_total + r->transmitted_total + r->ballistic + r->absorbed[0], 1, 2e-3);
}

TEST(MonteCarlo, HalfSpaceOfGiovanelli) {
  const double surface = optics::fresnel(1, 1.5);  // his number includes it
  const auto r = profile::monte_carlo(profile::scene_of(Medium{1, 9, 0, 1.5}), {.photons = 100'000, .seed = 1, .cache = {}});
  expect_sigma(surface + (1 - surface) * r->reflected_total, r->reflected_total_error, .2600, 0, "Rd with surface");
}

TEST(MonteCarlo, ThreeLayersOfTheMcmlManual) {
  const ScatterScene skin{.layers = {{{1 * from_cm, 100 * from_cm, .9, 1.37}, 1},
                                     {{1 * from_cm, 10 * from_cm, 0, 1.37}, 1},
                                     {{2 * from_cm, 10 * from_cm, .7, 1.37}, 2}}};
  const auto r = profile::monte_carlo(skin, {.photons = 200'000, .seed = 3, .cache = {}});
  const double entered = 1 - .0243729;
  expect_sigma(entered * r->reflected_total, entered * r->reflected_total_error, .237859, .00031, "Rd");
  expect_sigma(entered * (r->transmitted_total + r->ballistic), entered * r->transmitted_total_error, .0962202, .00019, "T");
  const double absorbed[] = {.2612, .1488, .2316};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(entered * r->absorbed[i], absorbed[i], 2e-3) << i;
}

/// Three standard errors of a ring that holds the part `energy` of the light sent, ours of `photons` and theirs of 1e6: weights are at most
/// 1, so no ring is noisier than counting.
double three_sigma(double energy, double photons) { return 3 * std::sqrt(energy / photons + energy / 1e6); }

// Rings of 0.1 mm, 1/cm^2: all 30 reflected ones, all 20 transmitted ones.
TEST(MonteCarlo, RingsOfTheMcmlManual) {
  const ScatterScene skin{.layers = {{{1 * from_cm, 100 * from_cm, .9, 1.37}, 1},
                                     {{1 * from_cm, 10 * from_cm, 0, 1.37}, 1},
                                     {{2 * from_cm, 10 * from_cm, .7, 1.37}, 2}}};
  const double reflected[] = {30.924, 10.071, 6.1187, 4.4015, 3.5138, 2.8528, 2.4344, 2.0692, 1.7715, 1.5409,
                              1.3425, 1.2006, 1.0319, .89424, .79300, .70183, .61493, .54537, .48518, .42576,
                              .37759, .32900, .29997, .26421, .23595, .20775, .18657, .16498, .14860, .14064};
  const double transmitted[] = {.58942, .60085, .56453, .55132, .53655, .53603, .52027, .49193, .46582, .43591,
                                .41109, .39854, .36636, .33945, .32122, .29694, .28041, .26182, .23866, .22141};
  constexpr double photons = 200'000, entered = 1 - .0243729;
  const auto r = profile::monte_carlo(skin, {.photons = 200'000, .seed = 3, .cache = {}});  // kept from the test above
  const auto area_cm2 = [](int i) { return M_PI * .0001 * (2 * i + 1); };
  const profile::MonteCarloProfile curve(skin, {.photons = 200'000, .seed = 3, .cache = {}});
  for (int i = 0; i < 30; ++i) {  // our rings are up to four times as wide as theirs: compared along the curve through them
    double ours = i == 0 ? r->reflected.within(.1) : 0;
    for (const auto& node : optics::gauss_legendre(8, .1 * std::max(i, 1), .1 * (i + 1)))
      if (i > 0) ours += 2 * M_PI * node.x * curve.at(node.x) * node.weight;
    const double theirs = reflected[i] * area_cm2(i);
    EXPECT_NEAR(entered * ours, theirs, three_sigma(theirs, photons)) << "reflected " << i << ": " << entered * ours / theirs;
  }
  double ours_all = 0, theirs_all = 0;
  for (int i = 0; i < 20; ++i) {
    const double ours = entered * (r->transmitted.within(.1 * (i + 1)) - r->transmitted.within(.1 * i)),
                 theirs = transmitted[i] * area_cm2(i);
    // Our rings are wider than theirs near the axis and spread their light evenly: 2 %
    EXPECT_NEAR(ours, theirs, three_sigma(theirs, photons) + .02 * theirs) << "transmitted " << i << ": " << ours / theirs;
    ours_all += ours, theirs_all += theirs;
  }
  EXPECT_NEAR(ours_all, theirs_all, three_sigma(theirs_all, photons));
}

TEST(MonteCarlo, HalfSpaceTotals) {
  struct Row {
    double albedo, normal, normal_error, diffuse, diffuse_error;
  };
  const double into_normal = 1 - optics::fresnel(1, 1 / 1.4), into_diffuse = 1 - .076812;
  for (const Row& row :
       {Row{.5, .05234, 9e-5, .05327, 9e-5}, Row{.8, .15300, 1.7e-4, .15331, 1.8e-4}, Row{.9, .25088, 2.2e-4, .24880, 2.2e-4},
        Row{.95, .35900, 2.4e-4, .35360, 2.5e-4}, Row{.99, .60359, 2.5e-4, .58379, 2.7e-4}, Row{.999, .83023, 1.8e-4, .79384, 2.4e-4}}) {
    const MonteCarloOptions options{.photons = 30'000, .seed = 11, .cache = {}};
    ScatterScene scene = profile::scene_of(Medium{1 - row.albedo, row.albedo, 0, 1.4});
    const auto normal = profile::monte_carlo(scene, options);
    expect_sigma(into_normal * normal->reflected_total, into_normal * normal->reflected_total_error, row.normal, row.normal_error,
                 "normal");
    scene.light = ScatterScene::Light::diffuse;
    const auto diffuse = profile::monte_carlo(scene, options);
    expect_sigma(into_diffuse * diffuse->reflected_total, into_diffuse * diffuse->reflected_total_error, row.diffuse, row.diffuse_error,
                 "diffuse");
  }
}

TEST(MonteCarlo, MeasuredSkinAndSlabs) {
  const double into = 1 - optics::fresnel(1, 1 / 1.3);
  const double truth[2][3] = {{.43230, .20983, .11338}, {.62350, .42943, .33342}};
  for (int skin = 0; skin < 2; ++skin)
    for (int c = 0; c < 3; ++c) {
      const auto r = profile::monte_carlo(profile::scene_of(optics::find_material(skin == 0 ? "skin1" : "skin2")->medium()[c]),
                                          {.photons = 50'000, .seed = 5, .cache = {}});
      expect_sigma(into * r->reflected_total, into * r->reflected_total_error, truth[skin][c], 2.5e-4, "skin" + std::to_string(skin + 1));
    }
  struct Slab {
    double d, rd, td, tb;
  };
  const double entered = 1 - optics::fresnel(1, 1 / 1.4);
  for (const Slab& slab : {Slab{1, .21144, .19176, .31449}, Slab{4, .26404, .08188, .01158}}) {
    const auto r = profile::monte_carlo({.layers = {{{.1, 1, 0, 1.4}, slab.d}}}, {.photons = 100'000, .seed = 9, .cache = {}});
    expect_sigma(entered * r->reflected_total, entered * r->reflected_total_error, slab.rd, 2e-4, "Rd");
    expect_sigma(entered * r->transmitted_total, entered * r->transmitted_total_error, slab.td, 2e-4, "Td");
    EXPECT_NEAR(entered * r->ballistic, slab.tb, 5e-3);
  }
  const auto two = profile::monte_carlo({.layers = {{{.5, 4, 0, 1.4}, .25}, {{.05, 2, 0, 1.4}, infinite}}},
                                        {.photons = 100'000, .seed = 9, .cache = {}});
  expect_sigma(entered * two->reflected_total, entered * two->reflected_total_error, .31169, 2e-4, "two layers");
}

// R(r) of an independent program, about 1 % noise.
TEST(MonteCarlo, RadialValues) {
  const profile::MonteCarloProfile skin(profile::scene_of(optics::find_material("skin1")->medium()[0]),
                                        {.photons = 200'000, .seed = 2, .cache = {}});
  struct Row {
    double r, value;
  };
  for (const Row& row : {Row{.15, 2.031e-1}, Row{.25, 1.047e-1}, Row{.45, 4.806e-2}, Row{.75, 2.360e-2}, Row{1.05, 1.471e-2},
                         Row{1.55, 8.222e-3}, Row{2.05, 5.380e-3}, Row{3.05, 2.612e-3}, Row{4.05, 1.422e-3}, Row{6.05, 4.812e-4}})
    EXPECT_NEAR(skin.at(row.r) / row.value, 1, 0.07) << row.r;  // three standard errors: 2 % a ring, theirs, and a ring's width
  EXPECT_NEAR(skin.hankel(0), skin.total(), 1e-12);
  EXPECT_NEAR(skin.within(skin.quantile(.5)), .5 * skin.total(), 1e-9);
  EXPECT_LT(skin.result().noise_percent(), 3);
}

TEST(MonteCarlo, EqualSeedsGiveEqualBitsAndFilesGiveThemBack) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("dermis_cache_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_mc");
  std::filesystem::remove_all(folder);
  const ScatterScene scene = profile::scene_of(Medium{.2, 1, 0.3, 1.4});
  const auto a = profile::monte_carlo(scene, {.photons = 5'000, .seed = 1, .cache = {}});
  const auto other = profile::monte_carlo(scene, {.photons = 5'000, .seed = 2, .cache = {}});
  EXPECT_NE(a->reflected_total, other->reflected_total);
  const MonteCarloOptions kept{.photons = 5'001, .seed = 1, .cache = folder};
  const auto first = profile::monte_carlo(scene, kept);
  for (int i = 0; i < 70; ++i)
    profile::monte_carlo(scene, {.photons = 1000, .seed = static_cast<std::uint64_t>(100 + i), .cache = {}});  // pushes it out of memory
  const auto second = profile::monte_carlo(scene, kept);
  EXPECT_NE(first.get(), second.get());
  EXPECT_EQ(first->reflected.energies(), second->reflected.energies());
  EXPECT_EQ(first->reflected_total, second->reflected_total);
  for (const auto& file : std::filesystem::directory_iterator(folder)) std::ofstream(file.path()) << "damaged";
  for (int i = 0; i < 70; ++i) profile::monte_carlo(scene, {.photons = 1000, .seed = static_cast<std::uint64_t>(300 + i), .cache = {}});
  EXPECT_EQ(profile::monte_carlo(scene, kept)->reflected.energies(), first->reflected.energies());
  std::filesystem::remove_all(folder);
  EXPECT_THROW(profile::monte_carlo(scene, {.photons = 1, .seed = 1, .cache = {}}), InputError);
}

// The rings that are integrated instead of sampled, against the other way to integrate them.
TEST(MonteCarlo, SinglyScatteredRingsAreThePhotonBeamsOwn) {
  for (const double g : {0.0, 0.6}) {
    const Medium medium{.2, 1, g, 1.4};
    const std::vector<profile::PhotonLayer> layers{{0, infinite, 1.2, 1 / 1.2, g, 1.4}};
    const profile::Annuli rings(profile::log_edges(1e-3, 50, 16), profile::single_rings(layers, profile::log_edges(1e-3, 50, 16)));
    const profile::SingleScattering single(medium);
    EXPECT_NEAR(rings.total() / single.total(), 1, 1e-3) << g;
    for (const double r : {.02, .2, 1.0}) EXPECT_NEAR(rings.within(r) / single.within(r), 1, 5e-3) << g << " " << r;
  }
}

// Totals per unit of flux that entered, n = 1.4: independent quadrature.
TEST(PhotonBeam, Totals) {
  struct Row {
    double albedo, multiple, single, both;
  };
  for (const Row& row : {Row{.5, .02747, .03163, .05910}, Row{.8, .11615, .05061, .16676}, Row{.9, .21124, .05694, .26818},
                         Row{.95, .32198, .06010, .38208}, Row{.99, .57886, .06263, .64149}, Row{.999, .81725, .06320, .88045}}) {
    const Medium medium{1 - row.albedo, row.albedo, 0, 1.4};
    EXPECT_NEAR(profile::BeamMultiple(medium).total(), row.multiple, 1e-4 * row.multiple + 5e-6) << row.albedo;
    EXPECT_NEAR(profile::SingleScattering(medium).total(), row.single, 1e-4 * row.single + 5e-6) << row.albedo;
    EXPECT_NEAR(profile::PhotonBeam(medium).total(), row.both, 1e-4 * row.both + 5e-6) << row.albedo;
  }
}

}  // namespace
}  // namespace dermis
