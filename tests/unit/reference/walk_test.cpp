// SPDX-License-Identifier: MIT
// The walk of the volume model, in a box of triangles, against published Monte-Carlo and exact values.
// [WJZ95] MCML and what its manual lists (van de Hulst, Giovanelli, Prahl); [C60] Chandrasekhar's H function.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/core/parallel.h"
#include "rays/surface_point.h"
#include "support/half_space.h"
#include "tissue/optics/fresnel.h"
#include "tissue/optics/radiative.h"
#include "truth/reference/walk.h"
#include "unit/reference/scenes.h"

namespace dermis::reference {
namespace {

/// More walks make a sharper test: DERMIS_WALKS=4000000 test_reference.
std::size_t walks_per_case() {
  const char* wanted = std::getenv("DERMIS_WALKS");
  return wanted ? static_cast<std::size_t>(std::atoll(wanted)) : 100'000;
}

struct Mean {
  double sum = 0, squares = 0;
  void add(double x) { sum += x, squares += x * x; }
};

/// Means over all walks of what came back, went through scattered, and went through unscattered, for one
/// channel.
struct Totals {
  Mean reflected, transmitted, ballistic;
};

enum class Light { perpendicular, diffuse };

std::array<Totals, 3> totals(const optics::RgbMedium& medium, double depth_mm, double half_mm, Light light,
                             std::uint64_t seed) {
  const scene::AssetData box = tests::box(depth_mm, half_mm);
  const rays::RayScene rays(box);
  const WalkMedium walked(medium, box.mm_per_unit);

  constexpr std::size_t batches = 64;
  const std::size_t per_batch = walks_per_case() / batches;
  std::vector<std::array<Totals, 3>> sums(batches);
  parallel_for(batches, [&](std::size_t batch) {
    for (std::size_t i = 0; i < per_batch; ++i) {
      Random random = random_of(seed, static_cast<std::uint32_t>(batch), static_cast<std::uint32_t>(i));
      glm::dvec3 d(0, 0, -1);
      double entered = 1 - optics::fresnel(1, 1 / walked.eta);
      if (light == Light::diffuse) {
        const double cosine = std::sqrt(random.next()), sine = std::sqrt(1 - cosine * cosine);
        entered = 1 - optics::fresnel(cosine, 1 / walked.eta);
        d = {sine, 0, -cosine};
      }

      const glm::dvec3 start(0, 0, -rays::stand_off_m(glm::dvec3(0)));
      const WalkEnd end =
          walk(rays, walked, start, refracted(d, glm::dvec3(0, 0, 1), 1 / walked.eta), random);
      EXPECT_NE(end.how, WalkEnd::How::lost);

      // Count what leaves through the top, through the bottom scattered, and through it unscattered.
      const double z = end.how == WalkEnd::How::left ? rays::surface_point(box, end.hit).face_normal.z : 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double weight = entered * end.weight[static_cast<int>(c)];
        sums[batch][c].reflected.add(z > 0.5 ? weight : 0);
        sums[batch][c].transmitted.add(z < -0.5 && end.scatterings > 0 ? weight : 0);
        sums[batch][c].ballistic.add(z < -0.5 && end.scatterings == 0 ? weight : 0);
      }
    }
  });

  std::array<Totals, 3> all;
  for (const auto& batch : sums)
    for (std::size_t c = 0; c < 3; ++c)
      for (Mean Totals::*part : {&Totals::reflected, &Totals::transmitted, &Totals::ballistic}) {
        (all[c].*part).sum += (batch[c].*part).sum;
        (all[c].*part).squares += (batch[c].*part).squares;
      }
  return all;
}

/// Within three standard errors, ours and the published one together.
void expect_mean(const char* what, const Mean& mean, double wanted, double wanted_error) {
  const double n = static_cast<double>(walks_per_case() / 64 * 64), value = mean.sum / n;
  const double error = std::sqrt((mean.squares / n - value * value) / (n - 1));
  const double z = (value - wanted) / std::hypot(error, wanted_error);
  std::printf("%-40s %.5f +- %.5f, published %.5f +- %.5f: z = %+.2f\n", what, value, error, wanted,
              wanted_error, z);
  EXPECT_LT(std::abs(z), 3) << what;
}

optics::RgbMedium grey(const optics::Medium& m) { return {m, m, m}; }

TEST(Walk, SlabOfVanDeHulst) {
  const auto t = totals(grey({.sigma_a_per_mm = 1, .sigma_s_per_mm = 9, .g = 0.75, .eta = 1}), 0.2, 20,
                        Light::perpendicular, 1);
  expect_mean("van de Hulst slab, reflected", t[0].reflected, 0.09739, 0.00001);
  expect_mean("van de Hulst slab, transmitted", t[1].transmitted, 0.66096 - std::exp(-2.0), 0.00002);
  expect_mean("van de Hulst slab, unscattered", t[2].ballistic, std::exp(-2.0), 0);
}

TEST(Walk, HalfSpaceOfGiovanelli) {
  const auto t = totals(grey({.sigma_a_per_mm = 1, .sigma_s_per_mm = 9, .g = 0, .eta = 1.5}), 20, 20,
                        Light::perpendicular, 2);
  expect_mean("Giovanelli half-space, n 1.5", t[0].reflected, 0.26 - 0.04, 0.00005);
}

TEST(Walk, ThreeMediaInOneWalkMatchTheExactHalfSpace) {
  // Three albedos and three densities: each channel must be right whichever one the steps were drawn for.
  optics::RgbMedium medium;
  const std::array<double, 3> albedo{0.5, 0.9, 0.99}, sigma_t{3, 1, 2};
  for (std::size_t c = 0; c < 3; ++c)
    medium[c] = {.sigma_a_per_mm = (1 - albedo[c]) * sigma_t[c],
                 .sigma_s_per_mm = albedo[c] * sigma_t[c],
                 .g = 0,
                 .eta = 1};
  const auto t = totals(medium, 100, 200, Light::perpendicular, 3),
             d = totals(medium, 100, 200, Light::diffuse, 4);
  for (std::size_t c = 0; c < 3; ++c) {
    expect_mean("Chandrasekhar, perpendicular", t[c].reflected,
                optics::exact_reflectance_perpendicular(albedo[c]), 0);
    expect_mean("Chandrasekhar, diffuse", d[c].reflected, optics::exact_reflectance_diffuse(albedo[c]), 0);
  }
}

TEST(Walk, MeasuredSkinReflectsAsPublished) {
  // Skin1 of [JMLH01], n 1.3, by an independent Monte-Carlo; the surface's 0.01701 is not part of it.
  optics::RgbMedium medium;
  const std::array<double, 3> s{0.74, 0.88, 1.01}, a{0.032, 0.17, 0.48}, wanted{0.43230, 0.20983, 0.11338};
  for (std::size_t c = 0; c < 3; ++c)
    medium[c] = {.sigma_a_per_mm = a[c], .sigma_s_per_mm = s[c], .g = 0, .eta = 1.3};
  const auto t = totals(medium, 100, 200, Light::perpendicular, 5);
  for (std::size_t c = 0; c < 3; ++c) expect_mean("skin1", t[c].reflected, wanted[c], 0.00025);
}

TEST(Walk, SlabAndHalfSpaceWithABoundary) {
  const auto slab = totals(grey({.sigma_a_per_mm = 0.1, .sigma_s_per_mm = 1, .g = 0, .eta = 1.4}), 1, 100,
                           Light::perpendicular, 6);
  expect_mean("slab n 1.4, reflected", slab[0].reflected, 0.21144, 0.0002);
  expect_mean("slab n 1.4, transmitted", slab[1].transmitted, 0.19176, 0.0002);
  expect_mean("slab n 1.4, unscattered", slab[2].ballistic, 0.31449, 0.0002);

  optics::RgbMedium medium;
  const std::array<double, 3> albedo{0.5, 0.8, 0.95}, normal{0.05234, 0.15300, 0.35900},
      diffuse{0.05327, 0.15331, 0.35360};
  const std::array<double, 3> normal_error{0.00009, 0.00017, 0.00024},
      diffuse_error{0.00009, 0.00018, 0.00025};
  for (std::size_t c = 0; c < 3; ++c)
    medium[c] = {.sigma_a_per_mm = 1 - albedo[c], .sigma_s_per_mm = albedo[c], .g = 0, .eta = 1.4};

  const auto n = totals(medium, 100, 200, Light::perpendicular, 7),
             d = totals(medium, 100, 200, Light::diffuse, 8);
  for (std::size_t c = 0; c < 3; ++c) {
    expect_mean("half-space n 1.4, perpendicular", n[c].reflected, normal[c], normal_error[c]);
    expect_mean("half-space n 1.4, diffuse", d[c].reflected, diffuse[c], diffuse_error[c]);
  }
}

}  // namespace
}  // namespace dermis::reference
