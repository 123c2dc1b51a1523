// SPDX-License-Identifier: MIT
// The kernels of techniques in screen space against published digits and closed forms.
#include "tissue/gaussians/screen_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tissue/gaussians/known.h"

namespace dermis::gaussians {
namespace {

// Offset, red, green, blue.
using Row = std::array<double, 4>;

Rgb sum_of(const std::vector<LineTap>& kernel) {
  Rgb sum{};
  for (const LineTap& tap : kernel)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += tap.weight[c];
  return sum;
}

Rgb variance_of(const std::vector<LineTap>& kernel) {
  Rgb variance{};
  for (const LineTap& tap : kernel)
    for (std::size_t c = 0; c < 3; ++c) variance[c] += tap.weight[c] * tap.offset * tap.offset;
  return variance;
}

// The middle, then one side outwards; the other side is its mirror image.
template <std::size_t N>
void expect_half(const std::vector<LineTap>& kernel, const std::array<Row, N>& half, double relative,
                 double absolute) {
  ASSERT_EQ(kernel.size(), 2 * N - 1);
  for (std::size_t i = 0; i < N; ++i)
    for (const bool left : {false, true}) {
      const LineTap& tap = kernel[i == 0 ? 0 : left ? N - i : N - 1 + i];
      EXPECT_NEAR(std::abs(tap.offset), half[i][0], 1e-5 * std::max(1.0, half[i][0])) << i;
      if (i > 0) { EXPECT_EQ(tap.offset < 0, left) << i; }
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(tap.weight[c], half[i][c + 1], std::max(absolute, relative * half[i][c + 1]))
            << "tap " << i << ", channel " << c;
    }
}

// Of the demo of [JZJ15]: its printed digits, six of each.
TEST(PublishedKernel, HasThePrintedDigits) {
  expect_half(published_line_kernel(25),
              std::array<Row, 13>{{{0, .530605, .613514, .739601},
                                   {.0208333, .0211412, .0459286, .0378196},
                                   {.0833333, .0402784, .0657244, .04631},
                                   {.1875, .0493588, .0367726, .0219485},
                                   {.333333, .0410172, .0199899, .0118481},
                                   {.520833, .0263642, .0119715, .00684598},
                                   {.75, .017924, .00711691, .00347194},
                                   {1.02083, .0128496, .00356329, .00132016},
                                   {1.33333, .0094389, .00139119, .000416598},
                                   {1.6875, .00700976, .00049366, .000151938},
                                   {2.08333, .00500364, .00020094, 5.28848e-5},
                                   {2.52083, .00333804, 7.85443e-5, 1.2945e-5},
                                   {3, .000973794, 1.11862e-5, 9.43437e-7}}},
              5e-6, 0);
  expect_half(published_line_kernel(17),
              std::array<Row, 9>{{{0, .536343, .624624, .748867},
                                  {.03125, .0324462, .0656718, .0532821},
                                  {.125, .0582416, .0659959, .0411329},
                                  {.28125, .0571056, .0287432, .0172844},
                                  {.5, .0347317, .0151085, .00871983},
                                  {.78125, .0216301, .00794618, .00376991},
                                  {1.125, .0144609, .00317269, .00106399},
                                  {1.53125, .0100386, .000914679, .000275702},
                                  {2, .00317394, .000134823, 3.77269e-5}}},
              5e-6, 0);
  expect_half(published_line_kernel(11),
              std::array<Row, 6>{{{0, .560479, .669086, .784728},
                                  {.08, .0771802, .113491, .0793803},
                                  {.32, .0821904, .0358608, .0209261},
                                  {.72, .03639, .0130999, .00643685},
                                  {1.28, .0192831, .00282018, .00084214},
                                  {2, .00471691, .000184771, 5.07566e-5}}},
              5e-6, 0);
}

TEST(PublishedKernel, KeepsTheLightAndSpreadsItAsFar) {
  struct Case {
    int taps;
    Rgb variance;
  };
  for (const Case& one : {Case{25, {.25128, .04061, .01821}}, Case{17, {.16376, .03739, .01737}},
                          Case{11, {.15647, .03310, .01514}}}) {
    const std::vector<LineTap> kernel = published_line_kernel(one.taps);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(sum_of(kernel)[c], 1, 1e-12);
      EXPECT_NEAR(variance_of(kernel)[c], one.variance[c], 6e-6);
    }
  }
}

// Integrals of the six Gaussians over the cells, computed for this test by other code, six digits of each.
TEST(LineSpreadKernel, HoldsTheIntegralsOfItsCells) {
  expect_half(line_spread_kernel(skin_six(), 25),
              std::array<Row, 13>{{{0, .083539, .157542, .198240},
                                   {.052083, .121334, .224152, .268960},
                                   {.208333, .088027, .129422, .108325},
                                   {.468750, .072054, .051405, .021709},
                                   {.833333, .059696, .013463, .001339},
                                   {1.302083, .046749, .002120, .000425},
                                   {1.875, .033081, .000421, .000111},
                                   {2.552083, .019757, .000170, .000011},
                                   {3.333333, .009751, .000059, 0},
                                   {4.21875, .004381, .000013, 0},
                                   {5.208333, .002047, .000002, 0},
                                   {6.302083, .000915, 0, 0},
                                   {7.5, .000439, 0, 0}}},
              0, 6e-7);
}

TEST(LineSpreadKernel, SpreadsAsFarAsTheProfile) {
  const ScatterProfile skin = skin_six();
  for (const int taps : {17, 25, 33}) {
    const std::vector<LineTap> kernel = line_spread_kernel(skin, taps);
    for (std::size_t c = 0; c < 3; ++c) {
      double variance = 0;
      for (const Gaussian& term : skin.terms) variance += term.weight[c] * term.variance_mm2;
      EXPECT_NEAR(sum_of(kernel)[c], 1, 1e-12);
      // Each cell has its light in its tap.
      EXPECT_NEAR(variance_of(kernel)[c] / variance, 1, taps == 17 ? 0.03 : 0.01) << taps << " taps, " << c;
    }
  }
}

// A head of twice the size has a kernel of half the offsets in its own mm, with the same weights.
TEST(LineSpreadKernel, FollowsTheWidthOfTheProfile) {
  ScatterProfile half = skin_six();
  for (Gaussian& term : half.terms) term.variance_mm2 /= 4;
  const std::vector<LineTap> whole = line_spread_kernel(skin_six(), 17),
                             narrow = line_spread_kernel(half, 17);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_NEAR(narrow[i].offset, whole[i].offset / 2, 1e-12);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(narrow[i].weight[c], whole[i].weight[c], 1e-12);
  }
}

TEST(LineSpreadKernel, KeepsLightOfAChannelThatDoesNotSpread) {
  ScatterProfile red = skin_six();
  for (Gaussian& term : red.terms) term.weight[2] = 0;
  const std::vector<LineTap> kernel = line_spread_kernel(red, 17);
  EXPECT_EQ(kernel[0].weight[2], 1);
  for (std::size_t i = 1; i < kernel.size(); ++i) EXPECT_EQ(kernel[i].weight[2], 0);
}

// The exact inverse, tabulated to four digits (the last may be off by one) beside the two approximations that
// renderers use.
TEST(Burley, InvertsItsShareOfLight) {
  constexpr std::array<std::pair<double, double>, 9> rows{{{.1, .2145},
                                                           {.25, .6037},
                                                           {.5, 1.5522},
                                                           {.75, 3.3979},
                                                           {.9, 6.0623},
                                                           {.95, 8.1286},
                                                           {.99, 12.9526},
                                                           {.997, 16.5644},
                                                           {.999, 19.8602}}};
  for (const auto& [share, radius] : rows) EXPECT_NEAR(burley_radius_of_share(share), radius, 1e-4) << share;
}

TEST(Burley, HasTheVarianceOfTheProfile) {
  const Rgb d = burley_distances_mm(skin_six());
  EXPECT_NEAR(d[0], .4445, 6e-5);
  EXPECT_NEAR(d[1], .0987, 6e-5);
  EXPECT_NEAR(d[2], .0595, 6e-5);
}

TEST(DiscTaps, HoldMostOfTheLightOfRed) {
  EXPECT_NEAR(radius_of_share_mm(skin_six(), 0, .997), 6.95, 0.005);
  EXPECT_EQ(disc_reach_mm(skin_six(), .997), radius_of_share_mm(skin_six(), 0, .997));
  EXPECT_NEAR(radius_of_share_mm(skin_six(), 0, 0), 0, 1e-9);
}

// Each tap stands for 1/n of the light of red: sums over the taps of a profile by its density are its
// integrals over the plane.
TEST(DiscTaps, IntegrateTheProfile) {
  const ScatterProfile skin = skin_six();
  constexpr int taps = 1024;
  Rgb sum{}, moment{};
  for (const DiscTap& tap : disc_taps(skin, taps)) {
    EXPECT_NEAR(std::hypot(tap.x_mm, tap.y_mm), tap.radius_mm, 1e-12);
    for (const Gaussian& term : skin.terms)
      for (std::size_t c = 0; c < 3; ++c) {
        const double share = term.weight[c] *
                             std::exp(-tap.radius_mm * tap.radius_mm / (2 * term.variance_mm2)) /
                             (2 * std::numbers::pi * term.variance_mm2) * tap.per_density_mm2 / taps;
        sum[c] += share;
        moment[c] += share * tap.radius_mm * tap.radius_mm / 2;
      }
  }
  const Rgb variance{1.3829, .0681, .0248};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(sum[c], 1, 0.002) << c;
    EXPECT_NEAR(moment[c] / variance[c], 1, 0.01) << c;
  }
}

TEST(DiscTaps, AreSpreadByTheWidestChannelOfBurley) {
  const std::vector<DiscTap> taps = burley_disc_taps({0.4, 0.1, 0.05}, 21);
  ASSERT_EQ(taps.size(), 21u);
  EXPECT_NEAR(taps[10].radius_mm, 0.4 * 1.5522, 1e-4);
  const double r = taps[10].radius_mm, d = 0.4;
  EXPECT_NEAR(taps[10].per_density_mm2 * (std::exp(-r / d) + std::exp(-r / (3 * d))),
              8 * std::numbers::pi * d * r, 1e-9);
}

}  // namespace
}  // namespace dermis::gaussians
