// SPDX-License-Identifier: MIT
// Computes the colour of spectral skin, and the skin that has a given colour.
// Based on: [DJ06] for the model; [PGW93] for the totals, which holds for dark skin too (the multipole is up
// to 40 % too bright there)
#pragma once

#include <string>

#include "tissue/optics/observer.h"
#include "tissue/optics/skin.h"

namespace dermis::optics {

/// Returns linear Rec.709 under D65 of the light that leaves from inside, per unit that entered: exact totals
/// (tissue/optics/radiative.h) at 81 wavelengths, integrated with the CIE 1931 observer. Takes about 10 ms.
/// This is what an albedo map holds; surface reflection is not included.
Rgb skin_reflectance(const SpectralSkin& skin);
/// Returns skin_reflectance() times entering_part(): the colour that an instrument measures without gloss.
Rgb skin_colour(const SpectralSkin& skin);

/// A skin found for a measured colour.
struct SkinMatch {
  SpectralSkin skin;
  Lab lab;             ///< colour of the found skin
  double delta_e = 0;  ///< CIE76 distance from the wanted colour; large for colours that no skin has
};

/// Returns the fixed parameters that fit measured skin best: blend 0.1, epidermis 0.12 mm, else the defaults.
/// Measured groups are at most 2.8 dE from the model with these, 9.3 dE with [DJ06]'s blend 0.7 and 0.25 mm.
SpectralSkin measured_skin();

/// Finds the melanin and haemoglobin whose skin_colour() is nearest to `wanted` in CIE76; all else is
/// `fixed`. A coarse grid, then Gauss-Newton from three of its best points until the distance falls by less
/// than 0.001; deterministic, about 0.1 s. Throws InputError if `fixed` is out of range.
SkinMatch nearest_skin(const Lab& wanted, const SpectralSkin& fixed = measured_skin());

/// Parses "#c58c85" (sRGB) or "L,a,b" (CIELAB, D65). Throws InputError (place `where`) otherwise, also for L
/// outside 0..100.
Lab parse_colour(const std::string& text, const std::string& where);

}  // namespace dermis::optics
