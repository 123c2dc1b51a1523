// SPDX-License-Identifier: MIT
// Reflection at a smooth boundary, and its averages over diffuse light. Indices are relative: n =
// n_incident_side / n_other_side, so n > 1 is light inside skin meeting air. Based on: [JMLH01] sec. 2.1
// (polynomial of Egan and Hilgeman); [DI11] d'Eon, Irving: A Quantized-Diffusion Model. SIGGRAPH 2011
// (moments)
#pragma once

namespace dermis::optics {

/// Unpolarised Fresnel reflectance, 0 to 1, for light that meets the boundary at cos_incident (0 to 1) from
/// the side of relative index n > 0. F = (r_par^2 + r_perp^2) / 2, Snell sin_t = n sin_i; 1 past the critical
/// angle.
double fresnel(double cos_incident, double n);

/// Diffuse Fresnel reflectance F_dr as a polynomial, n in 1/3..3 (layers of index 1 and 3 meet at the ends).
/// [JMLH01] sec. 2.1 for n > 1 (three-digit constants as printed there): F_dr = -1.440/n^2 + 0.710/n + 0.668
/// + 0.0636 n; for n < 1: -0.4399 + 0.7099/n - 0.3319/n^2 + 0.0636/n^3; n = 1: exactly 0.
double fresnel_diffuse_polynomial(double n);

/// First moment of fresnel(), 2 C1 = 2 Int_0^1 F(mu, n) mu dmu: what diffuse light loses at the boundary, 0
/// to 1; n in 1/3..3; by quadrature (1e-9). [DI11] sec. 4.
double fresnel_moment_2c1(double n);
/// Second moment, 3 C2 = 3 Int_0^1 F(mu, n) mu^2 dmu, 0 to 1; n and accuracy as above. [DI11] sec. 4.
double fresnel_moment_3c2(double n);

/// Boundary factor of the classical dipole, A = (1 + F_dr) / (1 - F_dr), dimensionless >= 1 for n > 1; n in
/// 1/3..3. [JMLH01] sec. 2.1; 1 for n = 1.
double boundary_factor_classical(double n);
/// Boundary factor of the better dipole, A = (1 + 3 C2) / (1 - 2 C1), dimensionless; n in 1/3..3. [DI11] eq.
/// 25 (as used by photon beam diffusion).
double boundary_factor_moments(double n);

}  // namespace dermis::optics
