// SPDX-License-Identifier: MIT
// Single values: the sRGB curve and half floats.
#pragma once

#include <cstdint>

namespace dermis::image {

/// The sRGB transfer curve (IEC 61966-2-1), display value in 0..1 -> linear light in 0..1. Not clamped:
/// negative values stay on the linear part.
float srgb_to_linear(float display);
/// Its inverse. srgb_to_linear(linear_to_srgb(x)) = x within 1e-6 on 0..1.
float linear_to_srgb(float linear);
/// The same for an 8-bit display value, from a table.
float srgb8_to_linear(std::uint8_t display);

/// The nearest 8-bit display value of linear light, clamped to 0..1, NaN gives 0; by a search in a table,
/// several times faster than the curve.
std::uint8_t linear_to_srgb8(float linear);

/// IEEE 754 binary16 bits, rounded to nearest, ties to even; beyond 65504 (plus half a step) infinite; NaN
/// stays NaN.
std::uint16_t float_to_half(float value);
/// Exact.
float half_to_float(std::uint16_t bits);
inline constexpr float max_half = 65504.0f;

}  // namespace dermis::image
