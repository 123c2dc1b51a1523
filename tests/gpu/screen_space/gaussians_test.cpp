// SPDX-License-Identifier: MIT
// Gaussians in screen space on a plane of which one half is lit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "plane.h"
#include "render/passes/scatter/kernels.h"
#include "tissue/gaussians/known.h"
#include "tissue/gaussians/screen_kernels.h"

namespace dermis::tests {
namespace {

using Row = std::vector<double>;

Row lit_half() {
  Row row(plane_width, 0.0);
  std::fill(row.begin(), row.begin() + plane_width / 2, 1.0);
  return row;
}

double at(const Row& row, int x) { return row[static_cast<std::size_t>(std::clamp(x, 0, plane_width - 1))]; }

Row blurred_by(const passes::HalfKernel& kernel, int spacing, const Row& row) {
  Row result(row.size());
  for (int x = 0; x < plane_width; ++x) {
    double sum = kernel[0] * at(row, x);
    for (int k = 1; k <= passes::kernel_radius; ++k)
      sum += kernel[static_cast<std::size_t>(k)] * (at(row, x - k * spacing) + at(row, x + k * spacing));
    result[static_cast<std::size_t>(x)] = sum;
  }
  return result;
}

// What a chain with so many taps per Gaussian makes of the row, per channel.
std::array<Row, 3> of_chain(int taps, double pixels_per_mm) {
  std::array<Row, 3> sums{Row(plane_width), Row(plane_width), Row(plane_width)};
  Row row = lit_half();
  double done_mm2 = 0;
  for (const Gaussian& term : gaussians::skin_six().terms) {
    const double sigma = std::sqrt(term.variance_mm2 - done_mm2) * pixels_per_mm, radius = taps / 2;
    const int spacing = std::max(1, static_cast<int>(std::ceil(sigma * 3 / radius)));
    row = blurred_by(passes::discrete_gaussian(sigma / spacing, taps / 2), spacing, row);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t x = 0; x < row.size(); ++x) sums[c][x] += term.weight[c] * row[x];
    done_mm2 = term.variance_mm2;
  }
  return sums;
}

double distance_from_rows(const Picture& picture, const std::array<Row, 3>& rows) {
  double largest = 0;
  for (int x = 0; x < plane_width; ++x)
    for (std::size_t c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(pixel(picture, x, middle_row)[c] - at(rows[c], x)));
  return largest;
}

TEST(ScreenGaussians, AreTheirKernelsOnAFacingPlane) {
  for (const int taps : {7, 9, 13})
    for (const double pixels_per_mm : {1.0, 3.0}) {
      RenderSettings s = facing_plane("screen-gaussians", pixels_per_mm);
      s.quality.taps = taps;
      const double off = distance_from_rows(renderer().render(lit_edge(), s), of_chain(taps, pixels_per_mm));
      std::printf("%d taps, %g pixels per mm: %.4f from their own kernels\n", taps, pixels_per_mm, off);
      EXPECT_LE(off, 0.005);
    }
}

TEST(ScreenGaussians, AreNearTheExactEdge) {
  struct Case {
    int taps;
    double pixels_per_mm, most;
  };
  for (const auto& [taps, pixels_per_mm, most] : {Case{5, 2, 0.08},
                                                  {7, 2, 0.02},
                                                  {9, 2, 0.015},
                                                  {13, 1, 0.01},
                                                  {13, 2, 0.015},
                                                  {13, 4, 0.015},
                                                  {13, 6, 0.03}}) {
    RenderSettings s = facing_plane("screen-gaussians", pixels_per_mm);
    s.quality.taps = taps;
    const auto [r, g, b] = distance_from_exact(renderer().render(lit_edge(), s), s, 0);
    std::printf("%d taps, %g pixels per mm: %.4f %.4f %.4f from the exact edge\n", taps, pixels_per_mm, r, g,
                b);
    EXPECT_LE(std::max({r, g, b}), most);
  }
}

// Along the tilt, across it, and between both.
TEST(ScreenGaussians, SpreadAsFarOnATiltedPlane) {
  for (const double tilt_deg : {0.0, 30.0, 60.0, 75.0})
    for (const double azimuth_deg : {0.0, 45.0, 90.0}) {
      const RenderSettings s = facing_plane("screen-gaussians", 5, tilt_deg, azimuth_deg);
      const double spread = spread_of_red(renderer().render(lit_edge(), s), s);
      std::printf("tilt %g, towards %g: %.4f of the width\n", tilt_deg, azimuth_deg, spread);
      EXPECT_NEAR(spread, 1, 0.03);
    }
}

// The light between two pixels of a row.
double between(const Row& row, double x) {
  const double before = std::floor(x - 0.5), share = x - 0.5 - before;
  return (1 - share) * at(row, static_cast<int>(before)) + share * at(row, static_cast<int>(before) + 1);
}

// Seven taps one sigma apart, and a part that is not blurred.
TEST(ScreenGaussians, AreThePublishedOnesOnAFacingPlane) {
  constexpr double pixels_per_mm = 3, weights[] = {0.382, 0.242, 0.061, 0.006};
  const gaussians::PartlyBlurred skin = gaussians::published_skin_gaussians();
  Row row = lit_half();
  std::array<Row, 3> sums{row, row, row};
  for (std::size_t c = 0; c < 3; ++c)
    for (double& light : sums[c]) light *= skin.unblurred[c];
  double done_mm2 = 0;
  for (const Gaussian& term : skin.terms) {
    const double sigma = std::sqrt(term.variance_mm2 - done_mm2) * pixels_per_mm;
    Row next(row.size());
    for (int x = 0; x < plane_width; ++x)
      for (int k = -3; k <= 3; ++k)
        next[static_cast<std::size_t>(x)] += weights[std::abs(k)] * between(row, x + 0.5 + k * sigma);
    row = next;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t x = 0; x < row.size(); ++x) sums[c][x] += term.weight[c] * row[x];
    done_mm2 = term.variance_mm2;
  }

  RenderSettings s = facing_plane("screen-gaussians", pixels_per_mm);
  s.quality.kernel = ScreenKernel::published;
  const double off = distance_from_rows(renderer().render(lit_edge(), s), sums);
  std::printf("published: %.4f from its own kernels\n", off);
  EXPECT_LE(off, 0.005);
}

// Their width knows the depth gradient up to a limit, which depends on the size of the picture: on a steep
// plane it is far too wide.
TEST(ScreenGaussians, AsPublishedSpreadTooFarOnATiltedPlane) {
  const auto spread_at = [](double tilt_deg) {
    RenderSettings s = facing_plane("screen-gaussians", 5, tilt_deg);
    s.quality.kernel = ScreenKernel::published;
    return spread_of_red(renderer().render(lit_edge(), s), s);
  };
  const double facing = spread_at(0);
  for (const double tilt_deg : {30.0, 60.0, 75.0})
    std::printf("published, tilt %g: %.4f of the width of a facing plane\n", tilt_deg,
                spread_at(tilt_deg) / facing);
  EXPECT_GT(spread_at(60) / facing, 1.3);
}

}  // namespace
}  // namespace dermis::tests
