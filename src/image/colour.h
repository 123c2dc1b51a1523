// SPDX-License-Identifier: MIT
// Converts single values: sRGB curve and half floats.
#pragma once

#include <cstdint>

namespace dermis::image {

/// Converts a display value in 0..1 to linear light by the sRGB transfer curve (IEC 61966-2-1). Does not
/// clamp: negative values stay on the linear part.
float srgb_to_linear(float display);
/// Inverse of srgb_to_linear(), within 1e-6 on 0..1.
float linear_to_srgb(float linear);
/// Converts an 8-bit display value, from a table.
float srgb8_to_linear(std::uint8_t display);

/// Returns the nearest 8-bit display value of linear light, clamped to 0..1; NaN gives 0. Searches a table,
/// which is several times faster than the curve.
std::uint8_t linear_to_srgb8(float linear);

/// Returns IEEE 754 binary16 bits, rounded to nearest, ties to even; 65520 and above become infinite; NaN
/// stays NaN.
std::uint16_t float_to_half(float value);
/// Exact inverse.
float half_to_float(std::uint16_t bits);
inline constexpr float max_half = 65504.0f;

}  // namespace dermis::image
