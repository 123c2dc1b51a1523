// SPDX-License-Identifier: MIT
// Tone maps: from linear light to what a display shows.
//
// [PBRN] Khronos Group: Khronos PBR Neutral Tone Mapper, specification, 2024
// [AgX] Sobotka: AgX, 2022; the base look with the primaries of Blender 4.0 (Chow: AgX_LUT_Gen, 2023), its
// curve as the polynomial of Wrensch: Minimal AgX Implementation, 2023
// [N15] Narkowicz: ACES Filmic Tone Mapping Curve, 2015
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "image/image.h"

namespace dermis::image {

/// R, G and B in the Rec.709 primaries.
using Colour = std::array<float, 3>;

/// The order is that of the shader (passes/tone_map/tone_map_io.h).
enum class ToneMap : std::uint32_t {
  /// The default. Leaves every colour alone whose greatest channel is at most 0.8, whatever its hue, and
  /// compresses what is brighter: a shoulder in which hue stays. See natural().
  natural,
  neutral,  ///< [PBRN], exact, with its toe
  agx,      ///< [AgX]
  filmic,   ///< [N15], each channel by itself
  srgb,     ///< clamped
  linear,   ///< clamped, and no sRGB curve
};

/// In the order of the enumeration; what --tone-map takes.
std::span<const std::string_view> tone_map_names();
std::string_view name_of(ToneMap tone_map);
/// InputError lists the names when there is none such.
ToneMap find_tone_map(std::string_view name);

/// Tone-mapped light, still linear, each channel 0 to 1. Negative channels and NaN count as 0, channels above
/// 65504 (the greatest half float) as that.
Colour tone_mapped(ToneMap tone_map, const Colour& linear);

/// The same as display values, 0 to 1: through the sRGB transfer curve, except `linear`.
Colour to_display(ToneMap tone_map, const Colour& linear);
/// The nearest of 256 display values.
std::array<std::uint8_t, 3> to_display8(ToneMap tone_map, const Colour& linear);

/// A linear picture of 1 to 4 channels as display values; 1 or 2 channels are grey (and alpha), alpha is
/// clamped and gets no curve.
Image8 to_display(const ImageF& linear, ToneMap tone_map);

}  // namespace dermis::image
