// SPDX-License-Identifier: MIT
// The best sum of Gaussians for a profile.
// Based on: [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin. CEIG 2008, eq. 2; [DLE07] d'Eon,
// Luebke, Enderton: Efficient Rendering
//           of Human Skin. EGSR 2007, sec. 4; [GP73] Golub, Pereyra: The Differentiation of Pseudo-Inverses
//           and Nonlinear Least Squares Problems Whose Variables Separate. 1973; [K75] Kaufman: A variable
//           projection method. BIT 15, 1975; [LH74] Lawson, Hanson: Solving Least Squares Problems. 1974, ch.
//           23
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "gaussians/sum.h"
#include "profile/radial.h"

namespace dermis::gaussians {

/// One term of a one-channel sum: w G(v, r), G = exp(-r^2/(2v)) / (2 pi v).
struct Term {
  double variance_mm2 = 0;
  double weight = 0;
};

/// Terms narrow to wide; weights as fitted, not normalised.
struct ChannelFit {
  std::vector<Term> terms;
  double error_percent = 0;  ///< 100 sqrt( Int r (R - S)^2 dr / Int r R^2 dr )
  double weight_sum() const;
};

/// non_negative is what a blur needs. any_sign serves the algebra of layers: a thin slab between unlike
/// neighbours has a multipole that is negative far out, which no sum of positive terms follows.
enum class Weights { non_negative, any_sign };

/// Minimises Int r (R - S)^2 dr ([JG08] eq. 2) over `terms` (1 to 8) variances > 0 and weights >= 0. By
/// Parseval (Int r f^2 dr = Int k f^^2 dk / (4 pi^2)) it works on R^ where that is known in closed form.
/// Where R has a 1/r pole (singly scattered light, Burley) Int r R^2 dr diverges at 0; there R and S are both
/// compared as a narrow Gaussian beam sees them, its sigma the radius that holds 5 % of the energy (0.02 to
/// 0.1 mm on pale skin; not under 0.01 mm unless half the energy is inside that): Int k (R^ - S^)^2 e^{-v
/// k^2} dk. Terms much narrower than that beam are not resolved and not made. Deterministic. Fewer terms come
/// back when two would coincide. InputError if the profile is 0 everywhere.
ChannelFit fit_channel(const profile::RadialProfile& profile, int terms,
                       Weights weights = Weights::non_negative);

/// The same for three channels that share their variances, the form that the GPU blurs; the sum of the three
/// squared relative errors is minimised. Weights come back divided by their sum per channel; the error is
/// that of the fit before the division; total_reflectance is the profile's own total. Mean free paths stay 0:
/// the caller knows them.
SumOfGaussians fit_shared(const std::array<profile::ProfilePtr, 3>& profiles, int terms,
                          const std::string& name);

/// Variance [mm^2] of the narrow beam through which a profile with a 1/r pole is fitted and its error
/// measured.
double core_variance_mm2(const profile::RadialProfile& profile);

/// The error of any sum against a profile, in per cent as above.
double error_percent(const profile::RadialProfile& profile, std::span<const Term> terms);

/// Channel c (0..2) of a sum, its weights times total_reflectance.
std::vector<Term> channel(const SumOfGaussians& sum, int c);

/// S(r) = Sum w_i G(v_i, r) [1/mm^2], r >= 0 in mm. [DLE07] sec. 4.
double evaluate(std::span<const Term> terms, double radius_mm);

}  // namespace dermis::gaussians
