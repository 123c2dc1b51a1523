// SPDX-License-Identifier: MIT
// Photons against numbers that others published, and against exact solutions. All comparisons at three
// standard errors, ours and theirs together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "base/core/error.h"
#include "tissue/optics/fresnel.h"
#include "tissue/optics/presets.h"
#include "tissue/optics/quadrature.h"
#include "tissue/profile/beam.h"
#include "tissue/profile/monte_carlo.h"
#include "tissue/profile/single_rings.h"

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

struct Mean {
  double value, error;  // standard
};

/// A quantity over runs with seeds of their own; its error from their spread, so that no quantity needs an
/// error of its own.
template <class Quantity>
Mean over_seeds(const ScatterScene& scene, std::uint64_t photons, Quantity&& quantity, int runs = 20) {
  double sum = 0, sum2 = 0;
  // results are kept: the next quantity of the same runs costs nothing
  for (int seed = 1; seed <= runs; ++seed) {
    const double value = quantity(*profile::monte_carlo(
        scene, {.photons = photons, .seed = static_cast<std::uint64_t>(seed), .cache = {}}));
    sum += value, sum2 += value * value;
  }
  const double mean = sum / runs;
  return {mean, std::sqrt(std::max(0.0, sum2 / runs - mean * mean) / (runs - 1))};
}

void expect_sigma(const Mean& mean, double truth, double truth_error, const std::string& what) {
  expect_sigma(mean.value, mean.error, truth, truth_error, what);
}

using Result = profile::MonteCarloResult;

TEST(MonteCarlo, SlabOfVanDeHulst) {
  const ScatterScene slab{.layers = {{{10 * from_cm, 90 * from_cm, 0.75, 1}, 0.2}}};
  const auto mean = [&](auto quantity) { return over_seeds(slab, 10'000, quantity); };
  expect_sigma(mean([](const Result& r) { return r.reflected_total; }), .09739, 0, "Rd");
  expect_sigma(mean([](const Result& r) { return r.transmitted_total + r.ballistic; }), .66096, 0, "Tt");
  expect_sigma(mean([](const Result& r) { return r.ballistic; }), std::exp(-2.0), 0, "Tb");
  expect_sigma(mean([](const Result& r) { return r.absorbed[0]; }), .241819, 2.3e-4, "A");
  const auto r = profile::monte_carlo(slab, {.photons = 10'000, .seed = 1, .cache = {}});
  EXPECT_NEAR(r->reflected_total + r->transmitted_total + r->ballistic + r->absorbed[0], 1, 2e-3);
}

TEST(MonteCarlo, HalfSpaceOfGiovanelli) {
  const double surface = optics::fresnel(1, 1.5);  // his number includes it
  const auto r = profile::monte_carlo(profile::scene_of(Medium{1, 9, 0, 1.5}),
                                      {.photons = 100'000, .seed = 1, .cache = {}});
  expect_sigma(surface + (1 - surface) * r->reflected_total, r->reflected_total_error, .2600, 0,
               "Rd with surface");
}

TEST(MonteCarlo, ThreeLayersOfTheMcmlManual) {
  const ScatterScene skin{.layers = {{{1 * from_cm, 100 * from_cm, .9, 1.37}, 1},
                                     {{1 * from_cm, 10 * from_cm, 0, 1.37}, 1},
                                     {{2 * from_cm, 10 * from_cm, .7, 1.37}, 2}}};

  EXPECT_NEAR(optics::fresnel(1, 1.37), .0243729, 5e-8);
  const double entered = 1 - .0243729;
  const auto mean = [&](auto quantity) {
    return over_seeds(skin, 5'000, [&](const Result& r) { return entered * quantity(r); });
  };

  expect_sigma(mean([](const Result& r) { return r.reflected_total; }), .237859, .00031, "Rd");
  expect_sigma(mean([](const Result& r) { return r.transmitted_total + r.ballistic; }), .0962202, .00019,
               "T");
  expect_sigma(mean([](const Result& r) { return r.absorbed[0] + r.absorbed[1] + r.absorbed[2]; }), .641594,
               .00036,
               "A");  // 1 - Rsp - Rd - T

  const double absorbed[] = {.2612, .1488, .2316};
  for (int i = 0; i < 3; ++i)
    expect_sigma(mean([&](const Result& r) { return r.absorbed[i]; }), absorbed[i], .00036,
                 "A of layer " + std::to_string(i));
}

// Fluence deep inside falls by 1.73 per cm (matched) and 1.74 (n = 1.37), both +-0.005; diffusion theory
// says 1.74.
TEST(MonteCarlo, FluenceDecaysAsPublished) {
  Medium medium{.1 * from_cm, 100 * from_cm, .9, 1};
  EXPECT_NEAR(medium.sigma_tr_per_mm() / from_cm, 1.74, .005);
  for (const double eta : {1.0, 1.37}) {
    medium.eta = eta;
    const ScatterScene deep{
        .layers = {{medium, 4}, {medium, 3}, {medium, 6}, {medium, 3}, {medium, infinite}}};
    const Mean decay = over_seeds(
        deep, 1'000, [](const Result& r) { return std::log(r.absorbed[1] / r.absorbed[3]) / 9 / from_cm; },
        6);
    expect_sigma(decay, eta == 1 ? 1.73 : 1.74, .005, "decay");
    EXPECT_LT(decay.error, .1);
  }
}

/// Three standard errors of a ring that holds the part `energy` of the light sent, ours of `photons` and
/// theirs of 1e6: weights are at most 1, so no ring is noisier than counting.
double three_sigma(double energy, double photons) { return 3 * std::sqrt(energy / photons + energy / 1e6); }

// Rings of 0.1 mm, 1/cm^2: all 30 reflected ones, all 20 transmitted ones.
TEST(MonteCarlo, RingsOfTheMcmlManual) {
  const ScatterScene skin{.layers = {{{1 * from_cm, 100 * from_cm, .9, 1.37}, 1},
                                     {{1 * from_cm, 10 * from_cm, 0, 1.37}, 1},
                                     {{2 * from_cm, 10 * from_cm, .7, 1.37}, 2}}};

  const double reflected[] = {30.924, 10.071, 6.1187, 4.4015, 3.5138, 2.8528, 2.4344, 2.0692, 1.7715, 1.5409,
                              1.3425, 1.2006, 1.0319, .89424, .79300, .70183, .61493, .54537, .48518, .42576,
                              .37759, .32900, .29997, .26421, .23595, .20775, .18657, .16498, .14860, .14064};
  const double transmitted[] = {.58942, .60085, .56453, .55132, .53655, .53603, .52027,
                                .49193, .46582, .43591, .41109, .39854, .36636, .33945,
                                .32122, .29694, .28041, .26182, .23866, .22141};

  constexpr double photons = 200'000, entered = 1 - .0243729;
  const auto r = profile::monte_carlo(skin, {.photons = 200'000, .seed = 3, .cache = {}});
  const auto area_cm2 = [](int i) { return M_PI * .0001 * (2 * i + 1); };
  const profile::MonteCarloProfile curve(skin, {.photons = 200'000, .seed = 3, .cache = {}});

  // our rings are up to four times as wide as theirs: compared along the curve through them
  for (int i = 0; i < 30; ++i) {
    double ours = i == 0 ? r->reflected.within(.1) : 0;
    for (const auto& node : optics::gauss_legendre(8, .1 * std::max(i, 1), .1 * (i + 1)))
      if (i > 0) ours += 2 * M_PI * node.x * curve.at(node.x) * node.weight;
    const double theirs = reflected[i] * area_cm2(i);
    EXPECT_NEAR(entered * ours, theirs, three_sigma(theirs, photons))
        << "reflected " << i << ": " << entered * ours / theirs;
  }

  double ours_all = 0, theirs_all = 0;
  for (int i = 0; i < 20; ++i) {
    const double ours = entered * (r->transmitted.within(.1 * (i + 1)) - r->transmitted.within(.1 * i)),
                 theirs = transmitted[i] * area_cm2(i);
    EXPECT_NEAR(ours, theirs, three_sigma(theirs, photons)) << "transmitted " << i << ": " << ours / theirs;
    ours_all += ours;
    theirs_all += theirs;
  }
  EXPECT_NEAR(ours_all, theirs_all, three_sigma(theirs_all, photons));
}

TEST(MonteCarlo, HalfSpaceTotals) {
  struct Row {
    double albedo, normal, normal_error, diffuse, diffuse_error;
  };

  const double into_normal = 1 - optics::fresnel(1, 1 / 1.4), into_diffuse = 1 - .076812;
  for (const Row& row :
       {Row{.5, .05234, 9e-5, .05327, 9e-5}, Row{.8, .15300, 1.7e-4, .15331, 1.8e-4},
        Row{.9, .25088, 2.2e-4, .24880, 2.2e-4}, Row{.95, .35900, 2.4e-4, .35360, 2.5e-4},
        Row{.99, .60359, 2.5e-4, .58379, 2.7e-4}, Row{.999, .83023, 1.8e-4, .79384, 2.4e-4}}) {
    const MonteCarloOptions options{.photons = 30'000, .seed = 11, .cache = {}};
    ScatterScene scene = profile::scene_of(Medium{1 - row.albedo, row.albedo, 0, 1.4});

    const auto normal = profile::monte_carlo(scene, options);
    expect_sigma(into_normal * normal->reflected_total, into_normal * normal->reflected_total_error,
                 row.normal, row.normal_error, "normal");

    scene.light = ScatterScene::Light::diffuse;
    const auto diffuse = profile::monte_carlo(scene, options);
    expect_sigma(into_diffuse * diffuse->reflected_total, into_diffuse * diffuse->reflected_total_error,
                 row.diffuse, row.diffuse_error, "diffuse");
  }
}

TEST(MonteCarlo, MeasuredSkinAndSlabs) {
  const double into = 1 - optics::fresnel(1, 1 / 1.3);
  const double truth[2][3] = {{.43230, .20983, .11338}, {.62350, .42943, .33342}};

  for (int skin = 0; skin < 2; ++skin)
    for (int c = 0; c < 3; ++c) {
      const auto r = profile::monte_carlo(
          profile::scene_of(optics::find_material(skin == 0 ? "skin1" : "skin2")->medium()[c]),
          {.photons = 50'000, .seed = 5, .cache = {}});
      expect_sigma(into * r->reflected_total, into * r->reflected_total_error, truth[skin][c], 2.5e-4,
                   "skin" + std::to_string(skin + 1));
    }

  struct Slab {
    double d, rd, td, tb, a;
  };
  const double entered = 1 - optics::fresnel(1, 1 / 1.4);
  for (const Slab& slab :
       {Slab{1, .21144, .19176, .31449, .25454}, Slab{4, .26404, .08188, .01158, .61473}}) {
    const ScatterScene scene{.layers = {{{.1, 1, 0, 1.4}, slab.d}}};
    const auto mean = [&](auto quantity) {
      return over_seeds(scene, 5'000, [&](const Result& r) { return entered * quantity(r); });
    };

    expect_sigma(mean([](const Result& r) { return r.reflected_total; }), slab.rd, 2e-4, "Rd");
    expect_sigma(mean([](const Result& r) { return r.transmitted_total; }), slab.td, 2e-4, "Td");
    expect_sigma(mean([](const Result& r) { return r.ballistic; }), slab.tb,
                 std::sqrt(slab.tb * (1 - slab.tb) / 2e6), "Tb");
    expect_sigma(mean([](const Result& r) { return r.absorbed[0]; }), slab.a, 2e-4, "A");
  }

  const auto two = profile::monte_carlo({.layers = {{{.5, 4, 0, 1.4}, .25}, {{.05, 2, 0, 1.4}, infinite}}},
                                        {.photons = 100'000, .seed = 9, .cache = {}});
  expect_sigma(entered * two->reflected_total, entered * two->reflected_total_error, .31169, 2e-4,
               "two layers");
}

// Nothing scatters: what each boundary reflects and each layer absorbs of light from everywhere can be summed
// for every direction.
TEST(MonteCarlo, IndexStepsWithoutScattering) {
  const ScatterScene stack{.layers = {{{.3, 0, 0, 1.5}, 1}, {{.2, 0, 0, 1.2}, 2}},
                           .light = ScatterScene::Light::diffuse};

  double entered = 0, reflected = 0, transmitted = 0;
  for (const auto& node : optics::gauss_legendre(64, 0, 1)) {
    const double sine = std::sqrt(1 - node.x * node.x), mu1 = std::sqrt(1 - sine * sine / 2.25),
                 mu2 = std::sqrt(1 - sine * sine / 1.44);
    const double flux = 2 * node.x * (1 - optics::fresnel(node.x, 1 / 1.5)) * node.weight;
    const double top = optics::fresnel(mu1, 1.5), step = optics::fresnel(mu1, 1.5 / 1.2),
                 bottom = optics::fresnel(mu2, 1.2);

    // Sum all bounces within layer 2, then those between the surface and what lies below layer 1.
    const double through1 = std::exp(-.3 / mu1), through2 = std::exp(-.4 / mu2);
    const double bounces2 = 1 / (1 - step * bottom * through2 * through2);
    const double below = step + (1 - step) * (1 - step) * bottom * through2 * through2 * bounces2;
    const double down = flux / (1 - top * below * through1 * through1);  // at the top of layer 1, all bounces

    entered += flux;
    reflected += down * through1 * through1 * below * (1 - top);
    transmitted += down * through1 * (1 - step) * bounces2 * through2 * (1 - bottom);
  }

  expect_sigma(over_seeds(stack, 5'000, [](const Result& r) { return r.reflected_total; }),
               reflected / entered, 0, "R");
  expect_sigma(over_seeds(stack, 5'000, [](const Result& r) { return r.ballistic; }), transmitted / entered,
               0, "T");
  expect_sigma(over_seeds(stack, 5'000, [](const Result& r) { return r.absorbed[0] + r.absorbed[1]; }),
               1 - (reflected + transmitted) / entered, 0, "A");
}

// Reciprocity: a stack lets as much light from everywhere through as the same stack upside down, per light
// sent. Light inside the upper layer meets the step past the critical angle.
TEST(MonteCarlo, IndexStepsAreReciprocal) {
  const profile::ScatterLayer upper{{.05, 1, .3, 1.6}, .8}, middle{{.02, .5, 0, 1.2}, 1},
      lower{{.2, 3, .5, 1.4}, .4};
  const auto passes = [](const ScatterScene& scene) {
    const double enters = 1 - optics::fresnel_moment_2c1(1 / scene.layers[0].medium.eta);
    return over_seeds(scene, 5'000,
                      [&](const Result& r) { return enters * (r.transmitted_total + r.ballistic); });
  };
  const Mean down = passes({.layers = {upper, middle, lower}, .light = ScatterScene::Light::diffuse});
  const Mean up = passes({.layers = {lower, middle, upper}, .light = ScatterScene::Light::diffuse});
  expect_sigma(down, up.value, up.error, "through the stack and through it upside down");
  EXPECT_LT(down.error, .01 * down.value);
}

/// Mean of R over the ring r +- 0.05 mm, along the curve through our rings, which are wider than that far
/// out.
double ring_mean(const profile::MonteCarloProfile& curve, double r) {
  const double low = r - .05, high = r + .05, area = M_PI * (high * high - low * low);
  if (low < 1e-9) return curve.within(high) / area;
  double energy = 0;
  for (const auto& node : optics::gauss_legendre(8, low, high))
    energy += 2 * M_PI * node.x * curve.at(node.x) * node.weight;
  return energy / area;
}

// R(r) of an independent program, about 1 % noise, in rings of 0.1 mm.
TEST(MonteCarlo, RadialValues) {
  const profile::MonteCarloProfile skin(profile::scene_of(optics::find_material("skin1")->medium()[0]),
                                        {.photons = 200'000, .seed = 2, .cache = {}});
  struct Row {
    double r, value;
  };
  const auto& rings = skin.result().reflected;
  for (const Row& row : {Row{.05, 7.430e-1}, Row{.15, 2.031e-1}, Row{.25, 1.047e-1}, Row{.45, 4.806e-2},
                         Row{.75, 2.360e-2}, Row{1.05, 1.471e-2}, Row{1.55, 8.222e-3}, Row{2.05, 5.380e-3},
                         Row{3.05, 2.612e-3}, Row{4.05, 1.422e-3}, Row{6.05, 4.812e-4}}) {
    const auto ring = std::upper_bound(rings.edges_mm().begin(), rings.edges_mm().end(), row.r) -
                      rings.edges_mm().begin() - 1;
    const double noise = skin.result().reflected_error[ring] / rings.energies()[ring];
    expect_sigma(ring_mean(skin, row.r) / row.value, noise, 1, .01, fmt::format("R({} mm)", row.r));
  }
  EXPECT_NEAR(skin.hankel(0), skin.total(), 1e-12);
  EXPECT_NEAR(skin.within(skin.quantile(.5)), .5 * skin.total(), 1e-9);
  EXPECT_LT(skin.result().noise_percent(), 3);
}

TEST(MonteCarlo, EqualSeedsGiveEqualBitsAndFilesGiveThemBack) {
  const auto folder =
      std::filesystem::temp_directory_path() /
      ("dermis_cache_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_mc");
  std::filesystem::remove_all(folder);

  const ScatterScene scene = profile::scene_of(Medium{.2, 1, 0.3, 1.4});
  const auto a = profile::monte_carlo(scene, {.photons = 5'000, .seed = 1, .cache = {}});
  const auto other = profile::monte_carlo(scene, {.photons = 5'000, .seed = 2, .cache = {}});
  EXPECT_NE(a->reflected_total, other->reflected_total);

  const MonteCarloOptions kept{.photons = 5'001, .seed = 1, .cache = folder};
  const auto first = profile::monte_carlo(scene, kept);
  for (int i = 0; i < 70; ++i)
    // pushes it out of memory
    profile::monte_carlo(scene, {.photons = 1000, .seed = static_cast<std::uint64_t>(100 + i), .cache = {}});
  const auto second = profile::monte_carlo(scene, kept);
  EXPECT_NE(first.get(), second.get());
  EXPECT_EQ(first->reflected.energies(), second->reflected.energies());
  EXPECT_EQ(first->reflected_total, second->reflected_total);

  for (const auto& file : std::filesystem::directory_iterator(folder))
    std::ofstream(file.path()) << "damaged";
  for (int i = 0; i < 70; ++i)
    profile::monte_carlo(scene, {.photons = 1000, .seed = static_cast<std::uint64_t>(300 + i), .cache = {}});
  EXPECT_EQ(profile::monte_carlo(scene, kept)->reflected.energies(), first->reflected.energies());

  std::filesystem::remove_all(folder);
  EXPECT_THROW(profile::monte_carlo(scene, {.photons = 1, .seed = 1, .cache = {}}), InputError);
}

// The rings that are integrated instead of sampled, against the other way to integrate them.
TEST(MonteCarlo, SinglyScatteredRingsAreThePhotonBeamsOwn) {
  for (const double g : {0.0, 0.6, -0.3, -0.6, -0.95, -0.999999}) {
    const Medium medium{.2, 1, g, 1.4};
    const std::vector<profile::PhotonLayer> layers{{0, infinite, 1.2, 1 / 1.2, g, 1.4}};
    const profile::Annuli rings(profile::log_edges(1e-3, 50, 16),
                                profile::single_rings(layers, profile::log_edges(1e-3, 50, 16)));
    const profile::SingleScattering single(medium);
    EXPECT_NEAR(rings.total() / single.total(), 1, 1e-3) << g;
    for (const double r : {.02, .2, 1.0})
      EXPECT_NEAR(rings.within(r) / single.within(r), 1, 5e-3) << g << " " << r;
  }
}

// Without a boundary the total is 2 pi (sigma_s / sigma_t) Int p_HG mu / (1 + mu) dmu: half of what scatters
// for g near -1.
TEST(PhotonBeam, BackwardLobes) {
  for (const double g : {0.5, 0.0, -0.5, -0.9, -0.999999, -1 + 1e-12}) {
    double truth = 0;
    // x = -ln(1 - mu): the lobe is as narrow as (1 + g)^2
    for (const auto& node : optics::gauss_legendre(200, 0, 70)) {
      const double off = std::exp(-node.x), turn = (1 + g) * (1 + g) - 2 * g * off;
      truth += node.weight * off * (1 - g) * (1 + g) / (2 * turn * std::sqrt(turn)) * (1 - off) / (2 - off);
    }
    const profile::SingleScattering single(Medium{0.2, 0.8, g, 1});
    EXPECT_NEAR(single.total() / (0.8 * truth), 1, 1e-3) << g;
    if (g < -0.99) { EXPECT_NEAR(single.total(), 0.4, 1e-3) << g; }
  }
}

// Totals per unit of flux that entered, n = 1.4: independent quadrature.
TEST(PhotonBeam, Totals) {
  struct Row {
    double albedo, multiple, single, both;
  };
  for (const Row& row : {Row{.5, .02747, .03163, .05910}, Row{.8, .11615, .05061, .16676},
                         Row{.9, .21124, .05694, .26818}, Row{.95, .32198, .06010, .38208},
                         Row{.99, .57886, .06263, .64149}, Row{.999, .81725, .06320, .88045}}) {
    const Medium medium{1 - row.albedo, row.albedo, 0, 1.4};
    EXPECT_NEAR(profile::BeamMultiple(medium).total(), row.multiple, 1e-4 * row.multiple + 5e-6)
        << row.albedo;
    EXPECT_NEAR(profile::SingleScattering(medium).total(), row.single, 1e-4 * row.single + 5e-6)
        << row.albedo;
    EXPECT_NEAR(profile::PhotonBeam(medium).total(), row.both, 1e-4 * row.both + 5e-6) << row.albedo;
  }
}

}  // namespace
}  // namespace dermis
