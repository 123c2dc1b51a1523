// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Imath/half.h>

#include <bit>
#include <cmath>
#include <limits>

#include "image/colour.h"

namespace dermis::image {
namespace {

TEST(Srgb, KnownValues) {
  EXPECT_EQ(srgb_to_linear(0), 0.0f);
  EXPECT_NEAR(srgb_to_linear(1), 1.0f, 1e-7);
  EXPECT_NEAR(srgb_to_linear(0.5f), 0.21404114f, 1e-7);
  EXPECT_NEAR(linear_to_srgb(0.18f), 0.46135613f, 1e-7);
  EXPECT_NEAR(srgb8_to_linear(188), 0.50288646f, 1e-6);
}

TEST(Srgb, IsItsInverse) {
  float last = -1;
  for (int i = 0; i <= 10000; ++i) {
    const float x = static_cast<float>(i) / 10000;
    EXPECT_NEAR(srgb_to_linear(linear_to_srgb(x)), x, 1e-6f);
    EXPECT_GE(linear_to_srgb(x), last);
    last = linear_to_srgb(x);
  }
  for (int i = 0; i < 256; ++i) EXPECT_EQ(linear_to_srgb8(srgb8_to_linear(static_cast<std::uint8_t>(i))), i);
}

TEST(Srgb, EightBitsAreTheNearest) {
  for (int i = -100; i <= 110000; ++i) {
    const float x = static_cast<float>(i) / 100000;
    const float exact = 255 * linear_to_srgb(x < 0 ? 0 : (x > 1 ? 1 : x));
    EXPECT_NEAR(linear_to_srgb8(x), exact, 0.5001f) << x;
  }
  EXPECT_EQ(linear_to_srgb8(std::numeric_limits<float>::quiet_NaN()), 0);
}

// Imath's half is the judge, over every exponent, both signs and all that a rounding can meet.
TEST(Half, MatchesImath) {
  for (std::uint32_t i = 0; i < 65536; ++i) {
    Imath::half half;
    half.setBits(static_cast<std::uint16_t>(i));
    const float expected = half;
    const float ours = half_to_float(static_cast<std::uint16_t>(i));
    ASSERT_EQ(std::bit_cast<std::uint32_t>(ours), std::bit_cast<std::uint32_t>(expected)) << i;
    if (!std::isnan(ours)) { ASSERT_EQ(float_to_half(ours), i); }
  }
  // sign, exponent, 8 bits of mantissa; then the bits that are rounded away
  for (std::uint32_t high = 0; high < 0x20000; ++high) {
    for (const std::uint32_t low : {0x0000u, 0x0001u, 0x0fffu, 0x1000u, 0x1001u, 0x1fffu, 0x2000u, 0x3000u,
                                    0x3001u, 0x5000u, 0x7000u}) {
      const float value = std::bit_cast<float>(high << 15 | low);
      if (std::isnan(value)) continue;
      ASSERT_EQ(float_to_half(value), Imath::half(value).bits()) << value;
    }
  }
}

TEST(Half, Edges) {
  EXPECT_EQ(float_to_half(65504.0f), 0x7bff);
  EXPECT_EQ(float_to_half(65519.996f), 0x7bff);
  EXPECT_EQ(float_to_half(65520.0f), 0x7c00);
  EXPECT_EQ(float_to_half(-std::numeric_limits<float>::infinity()), 0xfc00);
  EXPECT_EQ(float_to_half(-0.0f), 0x8000);
  EXPECT_EQ(float_to_half(0x1p-25f), 0);  // a tie between 0 and the smallest, to even
  EXPECT_EQ(float_to_half(0x1.8p-25f), 1);
  EXPECT_TRUE(std::isnan(half_to_float(float_to_half(std::numeric_limits<float>::quiet_NaN()))));
  EXPECT_TRUE(std::isnan(half_to_float(float_to_half(std::bit_cast<float>(0x7f800001u)))))
      << "a payload in the low bits alone";
}

}  // namespace
}  // namespace dermis::image
