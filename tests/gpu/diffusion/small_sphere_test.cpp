// SPDX-License-Identifier: MIT
// Curvature, charts and seams together: on a sphere of 10 mm a Gaussian of variance v damps band l by exp(-v
// l (l+1) / (2 R^2)).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "head/scene/import/shapes.h"
#include "head/scene/surface/unwrap.h"
#include "lab.h"

namespace dermis {
namespace {

constexpr double radius_mm = 10;
const std::vector<double> variances{0.187, 0.567, 1.99};

lab::Experiment sphere_experiment(std::uint32_t band, const glm::vec3& axis) {
  lab::Experiment e;
  e.scene = scene::sphere(radius_mm / 1000, 48, 0.04);
  e.map_size = 512;
  e.variances_mm2 = variances;
  e.paint = {.band = band, .edge_point = {}, .edge_normal = {}, .axis = glm::normalize(axis)};
  return e;
}

struct Damping {
  double fitted = 0;
  double worst = 0;  // deviation of a texel from the closed form, of the band's amplitude
};

Damping damping(const lab::Result& r, std::size_t level, double wanted) {
  double yp = 0, pp = 0;
  Damping d;
  for (int y = 0; y < r.painted.side; ++y)
    for (int x = 0; x < r.painted.side; ++x) {
      if (r.painted.at(x, y)[3] == 0) continue;
      const double p = r.painted.at(x, y)[0] - 1, got = r.levels[level].at(x, y)[0] - 1;
      yp += got * p;
      pp += p * p;
      d.worst = std::max(d.worst, std::abs(got - wanted * p) / 0.5);
    }
  d.fitted = yp / pp;
  return d;
}

TEST(SmallSphere, EachBandIsDamped) {
  if (!lab::available()) GTEST_SKIP() << "no Vulkan device";
  for (const std::uint32_t band : {1u, 2u, 4u})
    for (const glm::vec3 axis : {glm::vec3(0, 1, 0), glm::vec3(1, 2, -0.5f)}) {
      const lab::Result r = lab::run(sphere_experiment(band, axis));
      for (std::size_t i = 0; i < variances.size(); ++i) {
        const double wanted = std::exp(-variances[i] * band * (band + 1) / (2 * radius_mm * radius_mm));
        const Damping d = damping(r, i, wanted);
        EXPECT_NEAR(d.fitted / wanted, 1, 0.03) << "band " << band << ", variance " << variances[i];
        EXPECT_LT(d.worst, 0.03) << "band " << band << ", variance " << variances[i];
      }
    }
}

// Texels where two results of one light differ in a level.
std::size_t differing(const lab::Result& a, std::size_t level_a, const lab::Result& b, std::size_t level_b) {
  std::size_t differ = 0, lit = 0;
  for (int y = 0; y < a.painted.side; ++y)
    for (int x = 0; x < a.painted.side; ++x) {
      if (a.painted.at(x, y)[3] == 0) continue;
      const float* texel = a.levels[level_a].at(x, y);
      differ += !std::equal(texel, texel + 4, b.levels[level_b].at(x, y));
      ++lit;
    }
  EXPECT_GT(lit, 1000u);
  return differ;
}

// Their taps lie together, but where the wide one leaves texels out.
TEST(SmallSphere, TermsThatShareTheReadsOfTheLightAreAsEachAlone) {
  if (!lab::available()) GTEST_SKIP() << "no Vulkan device";
  lab::Experiment e = sphere_experiment(2, {1, 2, -0.5f});
  e.map_size = 128;
  const scene::SkinMesh skin = scene::skin_meshes(e.scene)[0];
  const double texels_per_mm =
      scene::unwrap_density(skin, e.scene.mm_per_unit).largest_uv_per_mm.p95 * e.map_size;
  const auto variance_mm2 = [&](double texels) { return texels * texels / texels_per_mm / texels_per_mm; };
  const auto run = [&](const std::vector<double>& variances_mm2) {
    lab::Experiment of_these = e;
    of_these.variances_mm2 = variances_mm2;
    of_these.from_light = variances_mm2.size() == 2;
    return lab::run(of_these);
  };

  const double narrow = variance_mm2(2), wide = variance_mm2(3.99), wider = variance_mm2(7);
  const lab::Result alone = run({narrow}), shared = run({narrow, wide});
  EXPECT_EQ(differing(alone, 0, shared, 0), 0u);
  EXPECT_EQ(differing(alone, 0, run({narrow, wider}), 0), 0u);
  EXPECT_EQ(differing(run({wide}), 0, shared, 1), 0u);
  EXPECT_GT(differing(shared, 0, shared, 1), 1000u);
}

// Without gutters light stops at the seams; the test must see that.
TEST(SmallSphere, MissingGuttersAreSeen) {
  if (!lab::available()) GTEST_SKIP() << "no Vulkan device";
  lab::Experiment e = sphere_experiment(4, {1, 2, -0.5f});
  e.gutters = false;
  const lab::Result r = lab::run(e);
  const double wanted = std::exp(-variances.back() * 20 / (2 * radius_mm * radius_mm));
  EXPECT_GT(damping(r, variances.size() - 1, wanted).worst, 0.03);
}

}  // namespace
}  // namespace dermis
