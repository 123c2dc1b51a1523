// SPDX-License-Identifier: MIT
// Light through slabs against the sum of Gaussians in closed form and against the reference, for one light
// and for four of all kinds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "dermis/reference.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "gpu/translucency/slab.h"
#include "head/scene/import/shapes.h"
#include "render/techniques/technique.h"

namespace dermis::tests {
namespace {

using std::numbers::pi;
constexpr double thicknesses_mm[] = {0.5, 1, 2, 4, 8};

struct Lit {
  std::vector<scene::Light> lights;
  glm::dvec3 irradiance{0};  // on the middle of the back
};

Lit lit(int lights, double thickness_mm) {
  Lit out;
  out.lights = {from_behind({3, 2, 1})};
  out.irradiance = {3, 2, 1};
  if (lights == 1) return out;
  out.lights.push_back(spot_behind({0.4f, 0.8f, 1.2f}));
  out.irradiance += glm::dvec3(0.4, 0.8, 1.2) / std::pow(0.6 - thickness_mm / 1000, 2);
  out.lights.push_back(point_behind({0.2f, 0.2f, 0.1f}));
  out.irradiance += glm::dvec3(0.2, 0.2, 0.1) / std::pow(0.3 - thickness_mm / 1000, 2);
  out.lights.push_back(from_behind({0.5f, 1, 2}));
  out.irradiance += glm::dvec3(0.5, 1, 2);
  return out;
}

Scene lit_slab(double thickness_mm, const std::vector<scene::Light>& lights) {
  scene::AssetData scene = slab(thickness_mm);
  scene.lights = lights;
  return wrap(std::move(scene));
}

// How far what a slab shows may be from the sum, over its lit side's radiance. Light is stored in half floats
// about twenty times on its way (see tests/gpu/golden), whose steps end at 2^-24. Its thickness is the
// difference of distances from a lamp, in floats: they are 6e-8 m apart where a lamp is 0.6 m away, and some
// four of them go into it.
double tolerance(double thickness_mm, std::size_t channel) {
  constexpr double off_mm = 4 * 6e-5, least = 1.0 / (1 << 24);
  const double share = slab_factor(thickness_mm)[channel];
  return 20 * (half_rounding * share + least) + slab_factor(thickness_mm - off_mm)[channel] - share;
}

TEST(Slab, ShowsTheSumOfGaussians) {
  for (const int lights : {1, 4})
    for (const double d : thicknesses_mm) {
      const Lit l = lit(lights, d);
      const Picture picture = renderer().render(lit_slab(d, l.lights), slab_settings());
      EXPECT_EQ(picture.statistics.lights, lights);
      EXPECT_EQ(picture.statistics.transmission_misses, 0u);
      const auto seen = mean_colour(picture), wanted = slab_factor(d);
      for (std::size_t c = 0; c < 3; ++c) {
        const double back = l.irradiance[static_cast<int>(c)] / pi;
        EXPECT_NEAR(seen[c], back * wanted[c], back * tolerance(d, c))
            << d << " mm, " << lights << " lights, channel " << c;
        std::printf("%4.1f mm, %d lights, channel %zu: %.5f, closed form %.5f\n", d, lights, c,
                    seen[c] / back, wanted[c]);
      }
    }
}

// The others find the same light where it leaves; a uniform slab does not show where it is blurred.
TEST(Slab, EveryTechniqueThatScattersShowsTheSum) {
  for (const std::string& technique : technique_names()) {
    if (!techniques::find_technique(technique).uses_profile) continue;
    for (const double d : {0.5, 2.0, 8.0}) {
      RenderSettings s = slab_settings();
      s.technique = technique;
      const Lit l = lit(4, d);
      const Picture picture = renderer().render(lit_slab(d, l.lights), s);
      EXPECT_TRUE(picture.statistics.translucency) << technique;
      const auto seen = mean_colour(picture), wanted = slab_factor(d);
      for (std::size_t c = 0; c < 3; ++c) {
        const double back = l.irradiance[static_cast<int>(c)] / pi;
        EXPECT_NEAR(seen[c], back * wanted[c], back * tolerance(d, c))
            << technique << ", " << d << " mm, " << c;
      }
    }
  }
}

// Without reflection both hold the same light, up to three standard errors of the reference.
TEST(Slab, IsThatOfTheReference) {
  const auto thin = slab_factor(0.5);
  for (const int lights : {1, 4})
    for (const double d : {0.5, 1.0, 2.0, 4.0}) {
      const Lit l = lit(lights, d);
      const Scene scene = lit_slab(d, l.lights);
      const RenderSettings s = slab_settings();
      const ReferencePicture truth = render_reference(scene, s, {.samples = 400});
      const auto seen = mean_colour(renderer().render(scene, s)), wanted = mean_colour(truth.picture);

      for (std::size_t c = 0; c < 3; ++c) {
        // Yields the standard error of the picture's mean.
        double variance = 0;
        for (std::size_t i = c; i < truth.variance_rgba.size(); i += 4)
          variance += double{truth.variance_rgba[i]};
        const double error = std::sqrt(variance) / static_cast<double>(truth.variance_rgba.size() / 4);
        const double back = l.irradiance[static_cast<int>(c)] / pi;

        EXPECT_LT(error, 0.02 * back * thin[c]) << "or the reference says nothing";
        EXPECT_NEAR(seen[c], wanted[c], back * tolerance(d, c) + 3 * error)
            << d << " mm, " << lights << " lights, channel " << c;
      }
    }
}

// The inside of skin that is open, as that of a bust, is no lit side of a body.
TEST(Slab, WithoutItsLitSideItStaysDark) {
  for (const double angle : {0.0, 50.0}) {
    scene::AssetData open = slab(1);
    std::vector<std::uint32_t>& indices = open.primitives.front().indices;
    indices.resize(indices.size() / 2);  // the front alone
    open.lights = {from_behind({3, 3, 3}, angle)};
    const auto seen = mean_colour(renderer().render(wrap(std::move(open)), slab_settings()));
    for (const double value : seen) EXPECT_LT(value, 1e-6) << angle << " degrees";
  }
}

// Light at an angle: the lit side gets less of it, the way is longer, the thickness is the same.
TEST(Slab, AtAnAngleItIsTheThicknessThatCounts) {
  for (const double angle : {30.0, 60.0})
    for (const double d : {0.5, 1.0, 2.0}) {
      const auto seen =
          mean_colour(renderer().render(lit_slab(d, {from_behind({2, 2, 2}, angle)}), slab_settings()));
      const auto wanted = slab_factor(d);
      const double back = 2 * std::cos(angle * pi / 180) / pi;
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(seen[c], back * wanted[c], back * tolerance(d, c))
            << angle << " degrees, " << d << " mm, channel " << c;
    }
}

TEST(Slab, LightsAddUp) {
  const std::vector<scene::Light> lights = lit(4, 1).lights;
  std::array<double, 3> sum{};
  for (const scene::Light& light : lights) {
    const auto one = mean_colour(renderer().render(lit_slab(1, {light}), slab_settings()));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += one[c];
  }
  const auto all = mean_colour(renderer().render(lit_slab(1, lights), slab_settings()));
  // The four pictures, and that of all, round by themselves.
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(all[c] / sum[c], 1, 5 * half_rounding);
}

TEST(Slab, SwitchedOffItIsDark) {
  RenderSettings s = slab_settings();
  s.skin.translucency = false;
  const Picture off = renderer().render(lit_slab(0.5, lit(4, 0.5).lights), s);
  EXPECT_FALSE(off.statistics.translucency);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(mean_colour(off)[c], 0);
  s.skin.translucency = true;
  EXPECT_TRUE(renderer().render(lit_slab(0.5, lit(1, 0.5).lights), s).statistics.translucency);
  s.technique = "lambert";
  const Picture lambert = renderer().render(lit_slab(0.5, lit(1, 0.5).lights), s);
  EXPECT_FALSE(lambert.statistics.translucency);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(mean_colour(lambert)[c], 0);
}

// Only skin lets light in, and what it keeps depends on its colour there, not here.
TEST(Slab, WhatCoversItKeepsTheLightOut) {
  scene::AssetData scene = slab(0.5);
  scene.lights = {from_behind({2, 2, 2})};
  scene::Primitive cover = scene::plane(0.06, glm::dmat2(1), {}, 1).primitives.front();
  for (scene::Vertex& v : cover.vertices) v.position_m.z = -0.0006f;
  cover.material = 1;
  scene.materials.push_back({.name = "cloth"});
  scene.primitives.push_back(cover);
  const Picture covered = renderer().render(wrap(std::move(scene)), slab_settings());
  EXPECT_EQ(covered.statistics.transmission_misses, 0u);
  for (const double value : mean_colour(covered)) EXPECT_EQ(value, 0);
}

TEST(Slab, TheColourOfTheLitSideActs) {
  scene::AssetData scene = slab(1);
  scene.lights = {from_behind({2, 2, 2})};
  RenderSettings s = slab_settings();
  s.lighting.white_albedo = false;
  s.skin.mix = 1;
  const auto white = mean_colour(renderer().render(wrap(scene), s));
  // The back's vertices stand behind those of the front.
  auto& vertices = scene.primitives.front().vertices;
  for (std::size_t i = vertices.size() / 2; i < vertices.size(); ++i)
    vertices[i].colour = {0.64f, 0.36f, 0.16f, 1};
  const auto tinted = mean_colour(renderer().render(wrap(scene), s));
  const double wanted[] = {0.64, 0.36, 0.16};
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(tinted[c] / white[c], wanted[c], 20 * half_rounding * wanted[c]);
}

// From one term to eight: every number of groups and targets.
TEST(Slab, AnyNumberOfTerms) {
  for (const std::size_t terms : {1u, 2u, 3u, 4u, 5u, 8u}) {
    std::vector<Gaussian> profile;
    double wanted = 0;
    for (std::size_t i = 0; i < terms; ++i) {
      const double variance_mm2 = 0.05 * std::pow(3.0, static_cast<double>(i)),
                   weight = 1.0 / static_cast<double>(terms);
      profile.push_back({.variance_mm2 = variance_mm2, .weight = {weight, weight, weight}});
      wanted += weight * std::exp(-0.25 / (2 * variance_mm2));
    }

    const RenderSettings s = with_profile(slab_settings(), std::to_string(terms) + " terms", profile);
    const auto seen = mean_colour(renderer().render(lit_slab(0.5, {from_behind({2, 2, 2})}), s));
    EXPECT_NEAR(seen[0] * pi / 2, wanted, 20 * half_rounding * wanted) << terms << " terms";
  }
}

}  // namespace
}  // namespace dermis::tests
