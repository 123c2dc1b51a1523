// SPDX-License-Identifier: MIT
// Light maps with so few texels that they would spread light further than skin does: terms that are lit at
// the pixel instead, against the reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "dermis/reference.h"
#include "gpu/support/failure.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "gpu/unwraps/made_up.h"
#include "head/scene/import/shapes.h"
#include "tissue/gaussians/known.h"

namespace dermis::tests {
namespace {

using std::numbers::pi;
constexpr double lamp_mm = 30;
constexpr int side_px = 24, fine = 4;

/// A plane of 1.5 m, whose texels are 47 mm wide on a map of 32, and a lamp 30 mm above it that makes its
/// middle white. The camera sees 60 mm each way.
Scene plane_under_a_lamp() {
  constexpr float lamp_m = static_cast<float>(lamp_mm / 1000);
  scene::AssetData made = scene::plane(1.5, glm::dmat2(1), {}, 16);
  made.lights.push_back({.name = "lamp",
                         .type = LightType::point,
                         .colour = glm::vec3(static_cast<float>(pi) * lamp_m * lamp_m),
                         .position_m = {0, 0, lamp_m}});
  made.cameras = {camera_from_above(0.06, {0, 0, 0.1f})};
  return wrap(std::move(made));
}

RenderSettings coarse_settings() {
  RenderSettings s = tiny_settings(side_px, 32);
  s.quality.shadow_size = 512;
  s.lighting.ambient = 0;
  s.lighting.specular = false;
  s.lighting.white_albedo = true;
  s.skin.translucency = false;
  return s;
}

/// In units of the light in the middle, over how far a pixel may be off.
struct Worst {
  double error = 0, over_bound = 0;
};

Worst worst_of(const ReferencePicture& truth, const image::ImageF& found) {
  // What is lit at the pixel misses the blur. By each Gaussian of variance v that changes light by v / 2
  // times its Laplacian, which is greatest below the lamp: E = (1 + r^2 / h^2)^(-3/2) bends by -6 / h^2
  // there.
  std::array<double, 3> missed{};
  for (const Gaussian& term : gaussians::skin_six().terms)
    for (std::size_t c = 0; c < 3; ++c)
      missed[c] += term.weight[c] * term.variance_mm2 / 2 * 6 / (lamp_mm * lamp_mm);

  // A sample stands for the mean of its part of a pixel, w wide: that is w^2 / 24 times the Laplacian.
  const double sample_mm = 120.0 / (side_px * fine),
               sampled = sample_mm * sample_mm / 24 * 6 / (lamp_mm * lamp_mm);

  Worst worst;
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    if (i % 4 == 3) continue;
    const double wanted = truth.picture.linear_rgba[i], error = std::abs(found.values[i] - wanted);
    // Of 1728 values one in a hundred thousand is further than 4.4 standard errors off.
    const double noise = 4.4 * std::sqrt(double{truth.variance_rgba[i]});
    worst.error = std::max(worst.error, error);
    worst.over_bound =
        std::max(worst.over_bound, error / (missed[i % 4] + sampled + 2 * half_rounding * wanted + noise));
  }
  return worst;
}

TEST(CoarseMap, TermsLitAtThePixelAreThoseOfTheReference) {
  const Scene scene = plane_under_a_lamp();
  RenderSettings s = coarse_settings();
  const ReferencePicture truth = render_reference(scene, s, {.samples = 256});
  const auto drawn = [&] { return downsampled(renderer().render(scene, super_sampled(s, fine)), fine); };

  const image::ImageF lit_at_the_pixel = drawn();
  const Worst with = worst_of(truth, lit_at_the_pixel);

  s.quality.depth = false;  // all is read from the map
  const Worst without = worst_of(truth, drawn());

  std::printf("off by %.4f of the light below the lamp, %.2f of the bound; from the map %.4f\n", with.error,
              with.over_bound, without.error);
  EXPECT_LE(with.over_bound, 1) << write_failure(linear(truth.picture), lit_at_the_pixel);
  EXPECT_GT(without.over_bound, 1);
  EXPECT_LT(with.error, without.error);
}

}  // namespace
}  // namespace dermis::tests
