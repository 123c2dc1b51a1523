// SPDX-License-Identifier: MIT
// The colour of spectral skin, and the skin behind a colour.
// Based on: [DJ06]; [PGW93] for the totals, so that dark skin is as right as light skin (the multipole would
// be up to 40 % too bright)
#pragma once

#include <string>

#include "optics/observer.h"
#include "optics/skin.h"

namespace dermis::optics {

/// Linear Rec.709 of the light that leaves from inside under D65, per unit that entered: the exact totals
/// (optics/radiative.h) at 81 wavelengths, integrated with the CIE 1931 observer. Some 10 ms. This is what an
/// albedo map means; what the surface reflects is not in it.
Rgb skin_reflectance(const Skin& skin);
/// The same as an instrument sees it without gloss: times entering_part().
Rgb skin_colour(const Skin& skin);

/// A skin found for a measured colour.
struct SkinMatch {
  Skin skin;
  Lab lab;             ///< of the found skin
  double delta_e = 0;  ///< CIE76 from what was asked for; large for colours that no skin has
};

/// Fixed parameters with which measured skin is met best: blend 0.1, epidermis 0.12 mm, else the defaults.
/// With [DJ06]'s own blend 0.7 and 0.25 mm measured groups are up to 9.3 dE from the model, with these 2.8.
Skin measured_skin();

/// The melanin and haemoglobin whose skin_colour() is nearest to `wanted` in CIE76; all else from `fixed`. A
/// coarse grid, then Gauss-Newton from its three best points apart until the distance no longer falls by
/// 0.001; deterministic, some 0.1 s. InputError: fixed out of range.
SkinMatch nearest_skin(const Lab& wanted, const Skin& fixed = measured_skin());

/// "#c58c85" (sRGB) or "L,a,b" (CIELAB, D65). InputError with `where` otherwise, also for L outside 0..100.
Lab parse_colour(const std::string& text, const std::string& where);

}  // namespace dermis::optics
