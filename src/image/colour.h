// SPDX-License-Identifier: MIT
// Colour of single values and of pictures: the sRGB curve, half floats, and the curves that turn linear light
// into a display picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "image/image.h"

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

/// x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), clamped to 0..1; x < 0 and NaN give 0. The value is still
/// linear: sRGB comes after. Source: Narkowicz, "ACES Filmic Tone Mapping Curve", 2015.
float filmic(float linear);

/// How a linear picture is shown. filmic: the curve above, then sRGB. srgb: clamped, then sRGB. linear:
/// clamped only.
enum class View { filmic, srgb, linear };
std::optional<View> view_named(std::string_view name);

/// Linear light to a display value in 0..1. NaN gives 0.
float apply_view(View view, float linear);
/// The nearest of 256 display values.
std::uint8_t to_display8(View view, float linear);

/// A linear picture of 1 to 4 channels as display values; 1 or 2 channels are grey (and alpha), alpha is
/// clamped and gets no curve.
Image8 to_display(const ImageF& linear, View view);

}  // namespace dermis::image
