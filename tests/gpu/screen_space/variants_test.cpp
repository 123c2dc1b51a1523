// SPDX-License-Identifier: MIT
// Variants of techniques in screen space that other renderers ship: Unreal Engine's weights.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "plane.h"
#include "tissue/gaussians/known.h"
#include "tissue/gaussians/screen_kernels.h"

namespace dermis::tests {
namespace {

// The share of a channel's light within a radius.
double share_in(std::size_t c, double r_mm) {
  double sum = 0;
  for (const Gaussian& term : gaussians::skin_six().terms)
    sum -= term.weight[c] * std::expm1(-r_mm * r_mm / (2 * term.variance_mm2));
  return sum;
}

double weight_at(std::size_t c, double r_mm) {
  double sum = 0;
  for (const Gaussian& term : gaussians::skin_six().terms)
    sum += term.weight[c] / term.variance_mm2 * std::exp(-r_mm * r_mm / (2 * term.variance_mm2));
  return sum;
}

// Taps begin a pixel from the middle, which has the share of each channel within.
TEST(UeKernel, IsItsTapsOnAFacingPlane) {
  constexpr double pixels_per_mm = 3;
  constexpr int taps = 64;
  RenderSettings s = facing_plane("burley-disc", pixels_per_mm);
  s.quality.kernel = ScreenKernel::ue;
  s.quality.taps = taps;
  const Picture picture = renderer().render(lit_edge(), s);

  const double within = share_in(0, 1 / pixels_per_mm);
  double largest = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    std::array<double, plane_width> light{};
    double weights = 0;
    for (int i = 0; i < taps; ++i) {
      const double r = gaussians::disc_reach_mm(gaussians::skin_six(),
                                                within + (1 - within) * (i + 0.5) / taps),
                   turns = i * 0.6180339887498949, angle = 2 * std::acos(-1.0) * (turns - std::floor(turns));
      const double weight = weight_at(c, r) / weight_at(0, r);
      weights += weight;
      for (int x = 0; x < plane_width; ++x)
        if (x + std::floor(0.5 + r * std::cos(angle) * pixels_per_mm) < plane_width / 2)
          light[static_cast<std::size_t>(x)] += weight;
    }
    const double middle = share_in(c, 1 / pixels_per_mm);
    // Far from the edges of the picture all taps are inside.
    for (int x = 60; x < plane_width - 60; ++x) {
      const double wanted = (1 - middle) * light[static_cast<std::size_t>(x)] / weights +
                            middle * (x < plane_width / 2 ? 1 : 0);
      largest = std::max(largest, std::abs(pixel(picture, x, middle_row)[c] - wanted));
    }
  }
  std::printf("%d taps of ue: %.4f from its own taps\n", taps, largest);
  EXPECT_LE(largest, 0.03);
}

// It weighs by r R(r): on tilted skin the kernel is too long along the tilt and too short across, by a ratio
// that does not depend on the profile. The share of the middle knows no tilt either, which widens both.
TEST(UeKernel, IsStretchedOnATiltedPlane) {
  struct Case {
    double tilt_deg, along, across;
  };
  for (const auto& [tilt_deg, along, across] :
       {Case{0, 1, 1}, Case{30, 1.018, .982}, Case{60, 1.081, .912}}) {
    const auto spread = [&, tilt = tilt_deg](double azimuth_deg) {
      RenderSettings s = facing_plane("burley-disc", 4, tilt, azimuth_deg);
      s.quality.kernel = ScreenKernel::ue;
      s.quality.taps = 400;
      return spread_of_red(renderer().render(lit_edge(), s), s);
    };
    const double found_along = spread(0), found_across = spread(90);
    std::printf("ue, tilt %g: %.4f along, %.4f across\n", tilt_deg, found_along, found_across);
    EXPECT_NEAR(found_along / found_across, along / across, 0.02);
    EXPECT_NEAR(found_along, along, 0.05);
  }
}

TEST(UeKernel, IsOneOfTheDiscAlone) {
  for (const std::string& technique : technique_names()) {
    RenderSettings s = small_settings(technique, 32);
    s.quality.kernel = ScreenKernel::ue;
    const bool refused =
        technique == "separable" || technique == "screen-gaussians" || technique == "pre-integrated";
    if (refused)
      EXPECT_THROW(renderer().render(lit_edge(), s), InputError) << technique;
    else
      EXPECT_NO_THROW(renderer().render(lit_edge(), s)) << technique;
  }
}

}  // namespace
}  // namespace dermis::tests
