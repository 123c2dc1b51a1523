// SPDX-License-Identifier: MIT
// Fits sums of Gaussians to profiles.
// Based on:
// [JG08]  Jimenez, Gutierrez: Faster Rendering of Human Skin. CEIG 2008, eq. 2
// [DLE07] d'Eon, Luebke, Enderton: Efficient Rendering of Human Skin. EGSR 2007, sec. 4
// [GP73]  Golub, Pereyra: The Differentiation of Pseudo-Inverses and Nonlinear Least Squares Problems Whose
//         Variables Separate. 1973
// [K75]   Kaufman: A variable projection method. BIT 15, 1975
// [LH74]  Lawson, Hanson: Solving Least Squares Problems. 1974, ch. 23
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "tissue/gaussians/sum.h"
#include "tissue/profile/radial.h"

namespace dermis::gaussians {

/// One term of a one-channel sum: w G(v, r), G = exp(-r^2/(2v)) / (2 pi v).
struct Term {
  double variance_mm2 = 0;
  double weight = 0;
};

/// Terms ordered narrow to wide; weights as fitted, not normalised.
struct ChannelFit {
  std::vector<Term> terms;
  double error_percent = 0;  ///< 100 sqrt( Int r (R - S)^2 dr / Int r R^2 dr )
  double weight_sum() const;
};

/// The measure that is minimised: Int r (R - S)^2 dr, or Int (E_R - E_S)^2 d(log r) with E(r) the light that
/// leaves within r.
using Measure = ProfileFit;

/// Fits `terms` (1 to 8) Gaussians of variance > 0 to a profile: minimises Int r (R - S)^2 dr, [JG08] eq. 2,
/// in R^ where that is known in closed form, or the measure of energy. The error is that of the plane either
/// way. Deterministic. Returns fewer terms if two would coincide. Throws InputError if the profile is 0
/// everywhere. Counts steps (base/core/hooks.h): may take seconds, and throws Cancelled if its caller ends
/// it.
///
/// If R has a 1/r pole (light scattered once, Burley), Int r R^2 dr diverges at 0. Then R and S are compared
/// as a narrow Gaussian beam sees them, see core_variance_mm2(): Int k (R^ - S^)^2 e^{-v k^2} dk. Terms much
/// narrower than the beam are not resolved and not made.
ChannelFit fit_channel(const profile::RadialProfile& profile, int terms, Measure measure = Measure::plane);

/// Fits three channels that share their variances, the form that the GPU blurs: minimises the sum of the
/// three squared relative errors. Weights are returned divided by their sum per channel, errors are those
/// before the division, total_reflectance is the profile's own total. Mean free paths stay 0: the caller
/// knows them.
ScatterProfile fit_shared(const std::array<profile::ProfilePtr, 3>& profiles, int terms,
                          const std::string& name, Measure measure = Measure::plane);

/// Returns the variance [mm^2] of the beam through which a profile with a 1/r pole is fitted and its error
/// measured. Its sigma is the radius that holds 5 % of the energy (0.02 to 0.1 mm on pale skin), but at least
/// 0.01 mm unless half the energy lies inside that.
double core_variance_mm2(const profile::RadialProfile& profile);

/// Returns the error of any sum against a profile, in per cent as in ChannelFit.
double error_percent(const profile::RadialProfile& profile, std::span<const Term> terms);

/// Returns channel c (0..2) of a sum, with weights multiplied by total_reflectance.
std::vector<Term> channel(const ScatterProfile& sum, int c);

/// Returns S(r) = Sum w_i G(v_i, r) [1/mm^2], r >= 0 in mm. [DLE07] sec. 4.
double evaluate(std::span<const Term> terms, double radius_mm);

/// E(x), the light at distance x [mm] into the dark (negative: in the light) from a straight edge, 0..1 for
/// normalised weights. [DLE07] fig. 2 idea, the integral of the sum over a half-plane.
double edge_response(std::span<const Term> terms, double x_mm);

/// Returns the distance of two normalised sums, in per cent: 100 sqrt( Int r (S - S')^2 dr / Int r S^2 dr ),
/// in closed form: Int r G(v) G(v') dr = 1 / (4 pi^2 (v + v')).
double difference_percent(std::span<const Term> sum, std::span<const Term> other);

}  // namespace dermis::gaussians
