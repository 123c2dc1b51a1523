// SPDX-License-Identifier: MIT
// The model "gaussians" against closed forms: a lit sphere, an even light, terms without width.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "head/scene/import/shapes.h"
#include "tissue/gaussians/known.h"
#include "unit/reference/scenes.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

Job gaussians_job(const scene::AssetData& scene, int side) {
  Job job = tests::furnace(scene, side);
  job.model = ReferenceModel::gaussians;
  job.setup.specular = false;
  return job;
}

ScatterProfile without_width(double share) {
  const auto rest = 1 - share;
  ScatterProfile sum;
  sum.terms = {{.variance_mm2 = 0, .weight = {share, share, share}},
               {.variance_mm2 = 2, .weight = {rest, rest, rest}}};
  return sum;
}

/// Light of a sphere of a radius under one light, where the cosine to the light is `cosine`, of one Gaussian
/// of the straight distance d: an area on the sphere is 2 pi d dd, and all points of a ring are as far.
double lit_sphere(double radius_mm, double cosine, double variance_mm2) {
  constexpr int chords = 200, angles = 48;
  const double sine = std::sqrt(1 - cosine * cosine),
               most_mm = std::min(2 * radius_mm, 9 * std::sqrt(variance_mm2));
  double sum = 0;
  for (int i = 0; i < chords; ++i) {
    const double d = (i + 0.5) / chords * most_mm, along = 1 - d * d / (2 * radius_mm * radius_mm),
                 across = std::sqrt(std::max(0.0, 1 - along * along));
    double ring = 0;
    for (int k = 0; k < angles; ++k)
      ring += std::max(0.0, cosine * along + sine * across * std::cos((k + 0.5) / angles * pi)) / angles;
    sum += std::exp(-d * d / (2 * variance_mm2)) / variance_mm2 * d * ring * most_mm / chords;
  }
  return sum;
}

glm::dvec3 lit_sphere(double radius_mm, double cosine) {
  glm::dvec3 sum(0);
  for (const Gaussian& g : gaussians::skin_six().terms)
    sum += glm::dvec3(g.weight[0], g.weight[1], g.weight[2]) * lit_sphere(radius_mm, cosine, g.variance_mm2);
  return sum;
}

// Published values of the sphere, from which the tables of pre-integrated skin are judged.
TEST(Gaussians, TheClosedFormOfASphereIsTheKnownOne) {
  struct Known {
    double radius_mm, cosine;
    glm::dvec3 value;
  };
  const Known known[] = {{5, 0.5, {.4787, .4987, .4995}}, {5, 0, {.0679, .0165, .0106}},
                         {5, -0.25, {.0199, .0002, 0}},   {10, 0.25, {.2494, .2498, .2499}},
                         {10, 0, {.0353, .0082, .0053}},  {20, 0, {.0178, .0041, .0027}},
                         {50, 0, {.0071, .0017, .0011}}};
  for (const Known& k : known)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(lit_sphere(k.radius_mm, k.cosine)[c], k.value[c], 2e-4) << k.radius_mm << " " << k.cosine;
}

// A light along x, seen along z: the cosine is that of the column, x / radius.
TEST(Gaussians, ALitSphereIsTheIntegralOverItsArea) {
  for (const double radius_mm : {5.0, 20.0}) {
    SCOPED_TRACE(radius_mm);
    constexpr int columns = 25, rows = 12;
    const scene::AssetData sphere = scene::sphere(radius_mm / 1000, 96);
    Job job = gaussians_job(sphere, columns);
    job.setup.height = rows;
    job.setup.ambient = 0;
    // Columns reach from one side to the other; rows stay near the equator.
    job.setup.camera = tests::camera_from_above(radius_mm / 1000 * rows / columns, {0, 0, 0.1f});
    job.setup.lights.push_back(
        {.name = "sun", .colour = glm::vec3(std::numbers::pi_v<float>), .direction = {-1, 0, 0}});
    const image::ImageF picture = tests::rendered(Tracer(sphere, job), 256).picture();

    for (int x = 3; x < columns - 3; ++x) {
      glm::dvec3 wanted(0), mean(0);
      constexpr int parts = 5;
      for (int i = 0; i < parts; ++i)
        wanted += lit_sphere(radius_mm, 2 * (x + (i + 0.5) / parts) / columns - 1) / double{parts};
      for (int y = 0; y < rows; ++y)
        for (int c = 0; c < 3; ++c) mean[c] += double{picture.at(x, y)[c]} / rows;
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(mean[c], wanted[c], 0.006) << "column " << x << ", channel " << c;
    }
  }
}

TEST(Gaussians, ASphereInEvenLightIsWhite) {
  const scene::AssetData sphere = scene::sphere(0.05, 32);
  Job job = gaussians_job(sphere, 16);
  for (const double share : {0.0, 0.4, 1.0}) {
    if (share > 0) job.profiles.assign(sphere.materials.size(), without_width(share));
    const image::ImageF picture = tests::rendered(Tracer(sphere, job), 128).picture();
    double mean = 0;
    int values = 0;
    for (std::size_t i = 0; i < picture.values.size(); i += 4) {
      if (picture.values[i + 3] < 1) continue;
      mean += double{picture.values[i]}, ++values;
    }
    ASSERT_GT(values, 50);
    EXPECT_NEAR(mean / values, 1, 0.003) << "share without width " << share;
  }
}

TEST(Gaussians, WithoutTermsOfNoWidthBothModelsGiveTheSameBits) {
  const scene::AssetData sphere = scene::sphere(0.005, 16);
  Job job = gaussians_job(sphere, 16);
  const Film own = tests::rendered(Tracer(sphere, job), 8, 3);
  job.model = ReferenceModel::bssrdf;
  EXPECT_EQ(own.state(), tests::rendered(Tracer(sphere, job), 8, 3).state());
}

// Half of an edge is sharp, the other half has the width of its Gaussian.
TEST(Gaussians, ATermWithoutWidthLeavesWhereItEntered) {
  scene::AssetData scene = scene::plane(0.12, glm::dmat2(1), {}, 1);
  tests::add_sheet(scene, 0.1f, 0.05f);
  Job job = gaussians_job(scene, 16);
  job.setup.height = 4;
  job.setup.ambient = 0;
  job.setup.camera = tests::camera_from_above(0.004 / 4, {0, 0, 0.02f});
  job.setup.lights.push_back({.name = "sun", .colour = glm::vec3(std::numbers::pi_v<float>)});
  job.profiles.assign(scene.materials.size(), without_width(0.5));
  const image::ImageF picture = tests::rendered(Tracer(scene, job), 1024).picture();

  for (int x = 0; x < picture.width; ++x) {
    constexpr int parts = 16;
    double wanted = 0, mean = 0;
    for (int i = 0; i < parts; ++i) {
      const double at_mm = -4 + 8 * (x + (i + 0.5) / parts) / picture.width;
      wanted += ((at_mm < 0 ? 0.5 : 0.0) + 0.25 * std::erfc(at_mm / 2)) / parts;  // sigma = sqrt(2)
    }
    for (int y = 0; y < picture.height; ++y) mean += double{picture.at(x, y)[0]} / picture.height;
    EXPECT_NEAR(mean, wanted, 0.01) << "column " << x;
  }
}

}  // namespace
}  // namespace dermis::reference
