// SPDX-License-Identifier: MIT
// Techniques in screen space on a plane of which one half is lit: each is its own kernel, pixel by pixel, and
// the distance from the profile on the surface is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "plane.h"
#include "tissue/gaussians/known.h"
#include "tissue/gaussians/screen_kernels.h"

namespace dermis::tests {
namespace {

using gaussians::LineTap;

// A row of light that falls from 1 to 0 between its two middle pixels, read between pixels.
double edge_between_pixels(double x) {
  x = std::clamp(x, 0.5, plane_width - 0.5) - 0.5;
  const double before = std::floor(x), share = x - before;
  const auto lit = [](double at) { return at < plane_width / 2 ? 1.0 : 0.0; };
  return (1 - share) * lit(before) + share * lit(before + 1);
}

// The largest difference from what a kernel makes of that row, in numbers of this test.
double distance_from_kernel(const Picture& picture, const std::vector<LineTap>& kernel,
                            double pixels_per_unit) {
  double largest = 0;
  for (int x = 0; x < plane_width; ++x) {
    const std::array<double, 3> found = pixel(picture, x, middle_row);
    for (std::size_t c = 0; c < 3; ++c) {
      double wanted = 0;
      for (const LineTap& tap : kernel)
        wanted += tap.weight[c] * edge_between_pixels(x + 0.5 + tap.offset * pixels_per_unit);
      largest = std::max(largest, std::abs(found[c] - wanted));
    }
  }
  return largest;
}

TEST(Separable, IsTheLineSpreadOfTheProfileOnAFacingPlane) {
  for (const int taps : {17, 25})
    for (const double pixels_per_mm : {1.0, 2.0, 4.0}) {
      RenderSettings s = facing_plane("separable", pixels_per_mm);
      s.quality.taps = taps;
      const double off =
          distance_from_kernel(renderer().render(lit_edge(), s),
                               gaussians::line_spread_kernel(gaussians::skin_six(), taps), pixels_per_mm);
      std::printf("%d taps, %g pixels per mm: %.4f from its own kernel\n", taps, pixels_per_mm, off);
      EXPECT_LE(off, 0.005);
    }
}

// A step in texture coordinates is longer in a wider picture: 4 times, here.
TEST(Separable, IsThePublishedKernelOnAFacingPlane) {
  constexpr double width_mm = 0.012 * 286.5, aspect = double{plane_width} / plane_height;
  for (const int taps : {11, 17, 25}) {
    RenderSettings s = facing_plane("separable", 2);
    s.quality.kernel = ScreenKernel::published;
    s.quality.taps = taps;
    const double off =
        distance_from_kernel(renderer().render(lit_edge(), s), gaussians::published_line_kernel(taps),
                             2 * width_mm / 3 * 2 * aspect);
    std::printf("published, %d taps: %.4f from its own kernel\n", taps, off);
    EXPECT_LE(off, 0.005);
  }
}

// Taps stand for cells of the kernel, which show as steps where pixels are finer than they are: with 25 taps
// up to 4 pixels per mm it is 2 %.
TEST(Separable, IsNearTheExactEdge) {
  struct Case {
    int taps;
    double pixels_per_mm, most;
  };
  for (const auto& [taps, pixels_per_mm, most] : {Case{17, 2, 0.02},
                                                  {25, 1, 0.02},
                                                  {25, 2, 0.02},
                                                  {25, 3, 0.02},
                                                  {25, 4, 0.02},
                                                  {25, 6, 0.04},
                                                  {33, 6, 0.02}}) {
    RenderSettings s = facing_plane("separable", pixels_per_mm);
    s.quality.taps = taps;
    const auto [r, g, b] = distance_from_exact(renderer().render(lit_edge(), s), s, 1 / pixels_per_mm);
    std::printf("%d taps, %g pixels per mm: %.4f %.4f %.4f from the exact edge\n", taps, pixels_per_mm, r, g,
                b);
    EXPECT_LE(std::max({r, g, b}), most);
  }
}

// Along the tilt, across it, and between both, where neither pass goes along it.
TEST(Separable, SpreadsAsFarOnATiltedPlane) {
  for (const double tilt_deg : {0.0, 30.0, 60.0, 75.0})
    for (const double azimuth_deg : {0.0, 45.0, 90.0}) {
      const RenderSettings s = facing_plane("separable", 5, tilt_deg, azimuth_deg);
      const double spread = spread_of_red(renderer().render(lit_edge(), s), s);
      std::printf("tilt %g, towards %g: %.4f of the width\n", tilt_deg, azimuth_deg, spread);
      EXPECT_NEAR(spread, 1, 0.03);
    }
}

// What a disc makes of that row: each tap takes the nearest pixel.
std::array<double, 3> of_disc(int x, const std::vector<gaussians::DiscTap>& taps, double pixels_per_mm) {
  std::array<double, 3> light{}, weights{};
  for (const gaussians::DiscTap& tap : taps) {
    const int at = x + static_cast<int>(std::floor(0.5 + tap.x_mm * pixels_per_mm)),
              row = middle_row + static_cast<int>(std::floor(0.5 - tap.y_mm * pixels_per_mm));
    if (at < 0 || at >= plane_width || row < 0 || row >= plane_height) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      double weight = 0;
      for (const Gaussian& term : gaussians::skin_six().terms)
        weight += term.weight[c] / term.variance_mm2 *
                  std::exp(-tap.radius_mm * tap.radius_mm / (2 * term.variance_mm2));
      weights[c] += weight * tap.per_density_mm2;
      if (at < plane_width / 2) light[c] += weight * tap.per_density_mm2;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) light[c] /= weights[c];
  return light;
}

TEST(BurleyDisc, IsTheProfileAtItsTapsOnAFacingPlane) {
  for (const int taps : {21, 40, 64, 1024}) {
    RenderSettings s = facing_plane("burley-disc", 3);
    s.quality.taps = taps;
    const Picture picture = renderer().render(lit_edge(), s);
    const std::vector<gaussians::DiscTap> disc = gaussians::disc_taps(gaussians::skin_six(), taps);
    double largest = 0;
    for (int x = 0; x < plane_width; ++x) {
      const std::array<double, 3> found = pixel(picture, x, middle_row), wanted = of_disc(x, disc, 3);
      for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(found[c] - wanted[c]));
    }
    std::printf("%d taps: %.4f from its own taps\n", taps, largest);
    EXPECT_LE(largest, 0.005);
  }
}

// Few taps are far from it, which others hide by noise over many frames.
TEST(BurleyDisc, IsNearTheExactEdge) {
  struct Case {
    int taps;
    double pixels_per_mm, most;
  };
  for (const auto& [taps, pixels_per_mm, most] :
       {Case{21, 2, 0.2}, {40, 2, 0.2}, {64, 2, 0.1}, {256, 2, 0.05}, {1024, 2, 0.01}, {1024, 4, 0.01}}) {
    RenderSettings s = facing_plane("burley-disc", pixels_per_mm);
    s.quality.taps = taps;
    const auto [r, g, b] = distance_from_exact(renderer().render(lit_edge(), s), s, 0);
    std::printf("%d taps, %g pixels per mm: %.4f %.4f %.4f from the exact edge\n", taps, pixels_per_mm, r, g,
                b);
    EXPECT_LE(std::max({r, g, b}), most);
  }
}

// Normalised diffusion has a pole in the middle, within a pixel, and a longer tail than the picture is high.
TEST(BurleyDisc, SpreadsAsFarOnATiltedPlane) {
  constexpr double tilt_deg = 60;
  for (const double azimuth_deg : {0.0, 45.0, 90.0})
    for (const ScreenKernel kernel : {ScreenKernel::profile, ScreenKernel::published}) {
      RenderSettings s = facing_plane("burley-disc", 4, tilt_deg, azimuth_deg);
      s.quality.taps = 1024;
      s.quality.kernel = kernel;
      const double spread = spread_of_red(renderer().render(lit_edge(), s), s);
      std::printf("%s, tilt %g, towards %g: %.4f of the width\n",
                  kernel == ScreenKernel::profile ? "profile" : "normalised diffusion", tilt_deg, azimuth_deg,
                  spread);
      EXPECT_NEAR(spread, 1, kernel == ScreenKernel::profile ? 0.03 : 0.04);
    }
}

// Two heads that touch: to the eye they are one plane.
TEST(ScreenSpace, HeadsExchangeNoLight) {
  for (const std::string& technique : technique_names()) {
    SCOPED_TRACE(technique);
    Scene scene;
    for (const bool white : {true, false}) scene.add({.asset = half_plane(white)});
    const Picture picture = renderer().render(scene, facing_plane(technique, 2));
    for (int x = 0; x < plane_width; ++x)
      for (const double light : pixel(picture, x, middle_row))
        ASSERT_NEAR(light, x < plane_width / 2 ? 1 : 0, 0.002) << x;
  }
}

}  // namespace
}  // namespace dermis::tests
