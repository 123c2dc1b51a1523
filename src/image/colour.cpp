// SPDX-License-Identifier: MIT
#include "image/colour.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace dermis::image {

float srgb_to_linear(float display) {
  return display <= 0.04045f
             ? display / 12.92f
             : static_cast<float>(std::pow((static_cast<double>(display) + 0.055) / 1.055, 2.4));
}

float linear_to_srgb(float linear) {
  return linear <= 0.0031308f
             ? linear * 12.92f
             : static_cast<float>(1.055 * std::pow(static_cast<double>(linear), 1 / 2.4) - 0.055);
}

float srgb8_to_linear(std::uint8_t display) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = srgb_to_linear(static_cast<float>(i) / 255.0f);
    return t;
  }();
  return table[display];
}

std::uint8_t linear_to_srgb8(float linear) {
  // The display value steps from i to i + 1 half-way between the two on the curve.
  static const std::array<float, 255> steps = [] {
    std::array<float, 255> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = srgb_to_linear((static_cast<float>(i) + 0.5f) / 255.0f);
    return t;
  }();
  if (!(linear > 0)) return 0;
  return static_cast<std::uint8_t>(std::upper_bound(steps.begin(), steps.end(), linear) - steps.begin());
}

std::uint16_t float_to_half(float value) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = bits >> 16 & 0x8000u;
  const std::uint32_t magnitude = bits & 0x7fffffffu;
  if (magnitude > 0x7f800000u) return static_cast<std::uint16_t>(sign | 0x7e00u);  // NaN
  // 65520 and above round to infinity
  if (magnitude >= 0x477ff000u) return static_cast<std::uint16_t>(sign | 0x7c00u);
  if (magnitude < 0x38800000u) {
    // Below 2^-14 a half is a multiple of 2^-24. Adding 0.5 to a float leaves exactly those bits, rounded by
    // the hardware to even.
    const float shifted = std::bit_cast<float>(magnitude) + 0.5f;
    return static_cast<std::uint16_t>(
        sign | (std::bit_cast<std::uint32_t>(shifted) - std::bit_cast<std::uint32_t>(0.5f)));
  }
  // Drops 13 bits. Adding just under half of the last place, plus one if that place is odd, rounds ties to
  // even.
  const std::uint32_t rounded = magnitude + 0xfffu + (magnitude >> 13 & 1u);
  return static_cast<std::uint16_t>(sign | (rounded - 0x38000000u) >> 13);
}

float half_to_float(std::uint16_t bits) {
  const std::uint32_t sign = (bits & 0x8000u) << 16;
  const std::uint32_t magnitude = bits & 0x7fffu;
  if (magnitude >= 0x7c00u) return std::bit_cast<float>(sign | 0x7f800000u | (magnitude & 0x3ffu) << 13);
  if (magnitude < 0x400u) {
    const float small = static_cast<float>(magnitude) * 0x1p-24f;
    return sign != 0 ? -small : small;
  }
  return std::bit_cast<float>(sign | ((magnitude << 13) + 0x38000000u));
}

}  // namespace dermis::image
