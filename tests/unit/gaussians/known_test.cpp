// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/core/error.h"
#include "tissue/gaussians/known.h"

namespace dermis::gaussians {
namespace {

TEST(Known, SkinIsWhiteAndOrdered) {
  const ScatterProfile skin = known("skin");
  ASSERT_EQ(skin.terms.size(), 6u);
  Rgb sum{};
  double last_mm2 = 0;
  for (const Gaussian& term : skin.terms) {
    EXPECT_GT(term.variance_mm2, last_mm2);
    last_mm2 = term.variance_mm2;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += term.weight[c];
  }
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1, 1e-12);
  EXPECT_EQ(skin.max_variance_mm2(), 7.41);
}

// Moments worked out from the published table by hand: mean square radius <r^2> = 2 sum w v and R(0) = sum w
// / (2 pi v). A slip in any digit of the table moves one of them.
TEST(Known, SkinHasThePublishedMoments) {
  const double mean_square_mm2[] = {2.76574, 0.13626, 0.04954};
  const double peak_per_mm2[] = {6.28552, 12.59060, 17.27245};
  for (std::size_t c = 0; c < 3; ++c) {
    double square = 0;
    double peak = 0;
    for (const Gaussian& term : skin_six().terms) {
      square += 2 * term.weight[c] * term.variance_mm2;
      peak += term.weight[c] / (2 * std::numbers::pi * term.variance_mm2);
    }
    EXPECT_NEAR(square, mean_square_mm2[c], 1e-5);
    EXPECT_NEAR(peak, peak_per_mm2[c], 1e-5);
  }
}

TEST(Known, EveryNameIsKnownAndOthersListThem) {
  for (const std::string_view name : known_names()) EXPECT_EQ(known(name).name, name);
  try {
    known("basalt");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "profile 'basalt' is not known; there are: skin, apple, chicken1, chicken2, cream, ketchup, marble, "
        "potato, skimmilk, skin1, skin2, spectralon, wholemilk, skin-layers");
  }
}

}  // namespace
}  // namespace dermis::gaussians
