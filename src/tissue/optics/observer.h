// SPDX-License-Identifier: MIT
// Converts a reflectance spectrum to colour: CIE 1931 observer, D65 light, linear Rec.709.
// Based on: CIE 015 (tables), IEC 61966-2-1 (matrix, transfer curve), CIE 015 sec. 8 (L*a*b*)
#pragma once

#include <array>
#include <span>

#include "tissue/optics/media.h"

namespace dermis::optics {

using Xyz = std::array<double, 3>;
/// CIELAB under D65: L* 0..100, a*, b*.
struct Lab {
  double l = 0, a = 0, b = 0;
};

/// Returns the samples of the tables: 380 to 780 nm, 5 nm apart.
std::span<const double> wavelengths_nm();

/// Returns the weights of reflectance at these wavelengths in linear Rec.709: RGB_c = Sum_i w_c[i] R(nm_i). A
/// white surface gives (1,1,1) exactly. Some weights are negative, because the primaries do not span all
/// spectral colours.
std::span<const Rgb> rec709_weights();

/// Returns XYZ = M RGB, M the matrix of IEC 61966-2-1 (any values); white (1,1,1) is D65 with Y = 1.
Xyz xyz_from_linear(const Rgb& linear);

/// Returns CIELAB of linear Rec.709 (any values), with white (1,1,1). CIE 015 sec. 8.
Lab lab_from_linear(const Rgb& linear);
/// Returns the inverse; colours outside Rec.709 have values outside 0..1.
Rgb linear_from_lab(const Lab& lab);
/// Returns CIE76, Delta E*ab: the Euclidean distance in L*a*b*, >= 0. CIE 015 sec. 8.
double delta_e76(const Lab& a, const Lab& b);

}  // namespace dermis::optics
