// SPDX-License-Identifier: MIT
// Reflection at a smooth boundary, and its means over diffuse light. Indices are relative:
// n = n_incident_side / n_other_side, so n > 1 is light inside skin that meets air.
// Based on:
// [JMLH01] sec. 2.1 (polynomial of Egan and Hilgeman)
// [DI11]   d'Eon, Irving: A Quantized-Diffusion Model. SIGGRAPH 2011 (moments)
#pragma once

namespace dermis::optics {

/// Returns the unpolarised Fresnel reflectance, 0 to 1, of light that meets the boundary at cos_incident (0
/// to 1) from the side of relative index n > 0. It is 1 past the critical angle.
double fresnel(double cos_incident, double n);

/// Returns the diffuse Fresnel reflectance F_dr, a polynomial of n in 1/3..3 (the ratios of indices 1 to 3).
/// [JMLH01] sec. 2.1, with the three-digit constants printed there for n > 1; exactly 0 for n = 1.
double fresnel_diffuse_polynomial(double n);

/// Returns the first moment of fresnel(), 2 C1 = 2 Int_0^1 F(mu, n) mu dmu, 0 to 1: the part of diffuse light
/// that the boundary reflects. n in 1/3..3; quadrature within 1e-9. [DI11] sec. 4.
double fresnel_moment_2c1(double n);
/// Returns the second moment, 3 C2 = 3 Int_0^1 F(mu, n) mu^2 dmu, 0 to 1; n and accuracy as above. [DI11]
/// sec. 4.
double fresnel_moment_3c2(double n);

/// Returns the boundary factor of the classical dipole, A = (1 + F_dr) / (1 - F_dr), dimensionless, >= 1 for
/// n > 1; 1 for n = 1; n in 1/3..3. [JMLH01] sec. 2.1.
double boundary_factor_classical(double n);

}  // namespace dermis::optics
