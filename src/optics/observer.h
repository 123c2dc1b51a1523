// SPDX-License-Identifier: MIT
// From a reflectance spectrum to colour: CIE 1931 observer, D65 light, linear Rec.709.
// Based on: CIE 015 (tables), IEC 61966-2-1 (matrix, transfer curve), CIE 015 sec. 8 (L*a*b*)
#pragma once

#include <array>
#include <functional>
#include <span>

#include "optics/media.h"

namespace dermis::optics {

using Xyz = std::array<double, 3>;
/// CIELAB under D65: L* 0..100, a*, b*.
struct Lab {
  double l = 0, a = 0, b = 0;
};

/// The samples of the tables: 380 to 780 nm, 5 nm apart.
std::span<const double> wavelengths_nm();

/// Weights by which reflectance at each of those wavelengths enters linear Rec.709: RGB_c = Sum_i w_c[i]
/// R(nm_i). A white surface gives (1,1,1) exactly. Some weights are negative: the primaries do not span the
/// spectrum's colours.
std::span<const Rgb> rec709_weights();

/// Linear Rec.709 under D65 of a reflectance (0..1) given by wavelength [nm]: RGB_c = Sum_i w_c[i] R(nm_i).
/// CIE 015; white is (1,1,1), and saturated spectra may leave 0..1.
Rgb linear_rgb(const std::function<double(double nm)>& reflectance);
/// XYZ = M RGB, M the matrix of IEC 61966-2-1 (any values); white (1,1,1) is D65 with Y = 1.
Xyz xyz_from_linear(const Rgb& linear);

/// CIELAB of linear Rec.709 (any values), white (1,1,1): L* = 116 f(Y/Yn) - 16, a* = 500 (f(X/Xn) - f(Y/Yn)),
/// b* = 200 (f(Y/Yn) - f(Z/Zn)), f(t) = t^(1/3) above (6/29)^3, else t / (3 (6/29)^2) + 4/29. CIE 015 sec. 8.
Lab lab_from_linear(const Rgb& linear);
/// Its inverse; colours outside Rec.709 come back with values outside 0..1.
Rgb linear_from_lab(const Lab& lab);
/// CIE76, Delta E*ab: the Euclidean distance in L*a*b*, >= 0. CIE 015 sec. 8.
double delta_e76(const Lab& a, const Lab& b);

}  // namespace dermis::optics
