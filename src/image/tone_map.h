// SPDX-License-Identifier: MIT
// Tone maps: convert linear light to display values.
// Based on:
// [PBRN] Khronos Group: Khronos PBR Neutral Tone Mapper, specification, 2024
// [AgX]  Sobotka: AgX, 2022; the base look with the primaries of Blender 4.0 (Chow: AgX_LUT_Gen, 2023), its
//        curve as the polynomial of Wrensch: Minimal AgX Implementation, 2023
// [N15]  Narkowicz: ACES Filmic Tone Mapping Curve, 2015
#pragma once

#include <array>
#include <cstdint>

#include "dermis/settings.h"
#include "image/image.h"

namespace dermis::image {

/// R, G and B in the Rec.709 primaries.
using Colour = std::array<float, 3>;

/// Returns tone-mapped light, still linear, each channel 0 to 1. Negative channels and NaN count as 0,
/// channels above 65504 (the largest half float) as 65504.
Colour tone_mapped(ToneMap tone_map, const Colour& linear);

/// Returns display values 0 to 1: tone-mapped light after the sRGB transfer curve (none for `linear`).
Colour to_display(ToneMap tone_map, const Colour& linear);
/// Returns the nearest of 256 display values.
std::array<std::uint8_t, 3> to_display8(ToneMap tone_map, const Colour& linear);

/// Converts a linear picture of 1 to 4 channels to display values; 1 or 2 channels are grey (and alpha).
/// Alpha is clamped only.
Image8 to_display(const ImageF& linear, ToneMap tone_map);

}  // namespace dermis::image
