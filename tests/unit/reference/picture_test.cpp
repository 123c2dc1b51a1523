// SPDX-License-Identifier: MIT
// Pictures of the reference whose every pixel is known.
#include <gtest/gtest.h>

#include <cmath>

#include "head/scene/import/shapes.h"
#include "image/colour.h"
#include "support/sanitized.h"
#include "tissue/gaussians/known.h"
#include "unit/reference/scenes.h"

namespace dermis::reference {
namespace {

/// Mean and worst deviation from `wanted` over pixels that are all skin; the worst is of single pixels, noise
/// included.
struct Deviation {
  double mean = 0, worst = 0;
  int pixels = 0;
};
Deviation deviation(const Film& film, const glm::dvec3& wanted) {
  const image::ImageF picture = film.picture();
  Deviation d;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const float* p = picture.at(x, y);
      if (p[3] < 1) continue;
      for (int c = 0; c < 3; ++c) {
        const double off = p[c] / wanted[c] - 1;
        d.mean += off;
        d.worst = std::max(d.worst, std::abs(off));
      }
      ++d.pixels;
    }
  d.mean /= 3.0 * d.pixels;
  return d;
}

TEST(Picture, VolumeFurnaceIsWhite) {
  const scene::AssetData sphere = scene::sphere(0.005, 16);
  for (const bool specular : {false, true}) {
    Job job = tests::furnace(sphere, 16);
    job.model = ReferenceModel::volume;
    job.setup.specular = specular;
    job.medium.fill({.sigma_a_per_mm = 0, .sigma_s_per_mm = 1, .g = 0.5, .eta = 1.4});
    const Deviation d = deviation(tests::rendered(Tracer(sphere, job), 4), glm::dvec3(1));
    EXPECT_GT(d.pixels, 100);
    EXPECT_LT(d.worst, 0.002) << "specular " << specular;
  }
}

// On a sphere of radius a, a Gaussian of the chord's length sums to 1 - exp(-2 a^2 / v): only what would lie
// beyond the far side is missing.
TEST(Picture, SphereKeepsTheLightOfItsProfile) {
  constexpr double radius_mm = 2.5;
  const scene::AssetData sphere = scene::sphere(radius_mm / 1000, 64);
  glm::dvec3 wanted(0);
  for (const Gaussian& g : gaussians::skin_six().terms)
    for (int c = 0; c < 3; ++c)
      wanted[c] +=
          g.weight[static_cast<std::size_t>(c)] * -std::expm1(-2 * radius_mm * radius_mm / g.variance_mm2);
  EXPECT_LT(wanted.r, 0.99);  // the far side does matter here
  Job job = tests::furnace(sphere, 24);
  job.setup.specular = false;
  const Deviation d = deviation(tests::rendered(Tracer(sphere, job), 256), wanted);
  EXPECT_LT(std::abs(d.mean), 0.001);
  EXPECT_LT(d.worst, 0.15);  // noise of single pixels
}

TEST(Picture, SurfaceFurnaceIsWhite) {
  // large against the profile: nothing reaches the far side
  const scene::AssetData sphere = scene::sphere(0.05, 32);
  for (const bool specular : {false, true}) {
    Job job = tests::furnace(sphere, 24);
    job.setup.specular = specular;
    const Deviation d = deviation(tests::rendered(Tracer(sphere, job), 128), glm::dvec3(1));
    EXPECT_LT(std::abs(d.mean), 0.002) << "specular " << specular;
  }
}

/// A plane of skin under a light from straight above, half of it in the shadow of a sheet.
scene::AssetData knife_edge() {
  scene::AssetData made = scene::plane(0.12, glm::dmat2(1), {}, 1);
  tests::add_sheet(made, 0.1f, 0.05f);
  return made;
}

/// The mean of Phi over a..b.
double mean_phi(double a, double b, double sigma) {
  const auto integral = [&](double x) {
    const double z = x / sigma;
    return sigma * (z * 0.5 * std::erfc(-z / std::sqrt(2.0)) +
                    std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi));
  };
  return (integral(b) - integral(a)) / (b - a);
}

TEST(Picture, KnifeEdgeIsTheAnalyticOne) {
  const scene::AssetData scene = knife_edge();
  constexpr std::uint32_t samples = tests::turns(2048, 512);

  Job job;
  job.setup.width = 24;
  job.setup.height = 16;
  job.setup.camera =
      tests::camera_from_above(0.004 * 16 / 24, {0, 0, 0.02f});  // between skin and sheet; 8 mm across
  job.setup.lights.push_back({.name = "sun", .colour = glm::vec3(std::numbers::pi_v<float>)});
  job.setup.white_albedo = true;
  job.setup.specular = false;
  job.profiles.assign(scene.materials.size(), gaussians::skin_six());

  const image::ImageF picture = tests::rendered(Tracer(scene, job), samples).picture();
  double worst = 0;
  for (int x = 0; x < picture.width; ++x) {
    const double width = 8.0 / picture.width, left = -4 + x * width;
    for (int c = 0; c < 3; ++c) {
      double mean = 0, wanted = 0;
      for (int y = 0; y < picture.height; ++y) mean += double(picture.at(x, y)[c]) / picture.height;
      for (const Gaussian& g : gaussians::skin_six().terms)
        wanted +=
            g.weight[static_cast<std::size_t>(c)] * mean_phi(-left - width, -left, std::sqrt(g.variance_mm2));
      worst = std::max(worst, std::abs(mean - wanted));
      EXPECT_NEAR(mean, wanted, 0.005) << "column " << x << ", channel " << c;
    }
  }

  std::printf("knife edge: at most %.4f of the peak away\n", worst);
}

// Stripes far finer than a pixel. Light enters and leaves through sqrt(albedo) each: the mean of the roots
// twice, not the mean of albedos, which a camera that filters its maps would see.
TEST(Picture, APixelIsTheMeanOfItsPointsNotOfItsMaps) {
  scene::AssetData scene = scene::plane(0.1, glm::dmat2(1), {}, 1);
  image::Image8 stripes{.width = 256, .height = 1, .rgba = {}};
  for (int x = 0; x < 256; ++x) {
    stripes.rgba.insert(stripes.rgba.end(), 3, x % 2 ? 255 : 56);
    stripes.rgba.push_back(255);
  }
  scene.images.push_back({"stripes", std::make_shared<const image::Image8>(stripes)});

  scene::Material& skin = scene.materials.front();
  skin.base_colour_map.image = 0;
  skin.base_colour_map.nearest = true;
  skin.skin_settings.mix = 0.5f;
  const double dark = image::srgb8_to_linear(56), root = (1 + std::sqrt(dark)) / 2;

  Job job;
  job.setup.width = job.setup.height = 4;
  job.setup.camera = tests::camera_from_above(0.01, {0, 0, 0.5f});
  job.setup.ambient = 1;
  job.setup.specular = false;
  job.profiles.push_back({.name = "wide", .terms = {{.variance_mm2 = 4, .weight = {1, 1, 1}}}});

  const Deviation d = deviation(tests::rendered(Tracer(scene, job), 4096), glm::dvec3(root * root));
  EXPECT_EQ(d.pixels, 16);
  EXPECT_LT(std::abs(d.mean), 0.01) << "filtered colour would give " << root * std::sqrt((1 + dark) / 2)
                                    << " instead of " << root * root;
}

}  // namespace
}  // namespace dermis::reference
