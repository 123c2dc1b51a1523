// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tissue/gaussians/known.h"
#include "tissue/gaussians/one.h"

namespace dermis::gaussians {
namespace {

TEST(OneGaussian, SpreadsLightAsFarAsTheSum) {
  const ScatterProfile six = skin_six(), one = one_gaussian(six);
  ASSERT_EQ(one.terms.size(), 1u);
  EXPECT_EQ(one.terms[0].weight, (Rgb{1, 1, 1}));
  // The published table by hand: red 1.3829, green 0.0681, blue 0.0248 mm^2.
  EXPECT_NEAR(one.terms[0].variance_mm2, (1.3829 + 0.0681 + 0.0248) / 3, 1e-4);
  const ScatterProfile again = one_gaussian(one);
  EXPECT_EQ(again.terms, one.terms) << "one stays what it is";
}

}  // namespace
}  // namespace dermis::gaussians
