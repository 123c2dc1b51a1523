// SPDX-License-Identifier: MIT
#include "tissue/profile/dipole.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tissue/optics/fresnel.h"
#include "tissue/profile/point_source.h"

namespace dermis::profile {
namespace {

using std::numbers::pi;

/// Returns e^{-s d} / d: 4 pi D times the fluence of the source of source_flux(). Its Hankel transform is
/// 2 pi e^{-z kappa} / kappa.
double source_fluence(double z, double radius, double s) {
  const double d = std::sqrt(radius * radius + z * z);
  return std::exp(-s * d) / d;
}

/// Returns the longest length of the profile. Without absorption the tail is a power law without a length: a
/// thousand mean free paths hold 99.9 % of the energy.
double reach_mm(double sigma_tr_per_mm, double mean_free_path_mm) {
  return sigma_tr_per_mm * 1000 * mean_free_path_mm > 1 ? std::max(1 / sigma_tr_per_mm, mean_free_path_mm)
                                                        : 1000 * mean_free_path_mm;
}

}  // namespace

Dipole::Dipole(const optics::Medium& medium)
    : reduced_albedo_(medium.reduced_albedo()),
      sigma_tr_per_mm_(medium.sigma_tr_per_mm()),
      z_real_mm_(medium.mean_free_path().mm),
      z_virtual_mm_(z_real_mm_ +
                    4 * optics::boundary_factor_classical(medium.eta) * medium.diffusion_coefficient_mm()) {}

double Dipole::at(double radius_mm) const {
  // [JMLH01] eq. 4, with s = sigma_tr, z_r = 1/sigma_t', z_v = z_r + 4 A D, d = sqrt(r^2 + z^2):
  //   R(r) = alpha'/(4 pi) [ z_r (1 + s d_r) e^{-s d_r} / d_r^3 + z_v (1 + s d_v) e^{-s d_v} / d_v^3 ]
  // Many copies divide the second term by sigma_t', which is wrong in dimension.
  return reduced_albedo_ / (4 * pi) *
         (source_flux(z_real_mm_, radius_mm, sigma_tr_per_mm_) +
          source_flux(z_virtual_mm_, radius_mm, sigma_tr_per_mm_));
}

double Dipole::hankel(double k_per_mm) const {
  // Exact: R^(k) = alpha'/2 [ e^{-z_r kappa} + e^{-z_v kappa} ], kappa = sqrt(s^2 + k^2).
  const double kappa = std::hypot(sigma_tr_per_mm_, k_per_mm);
  return reduced_albedo_ / 2 * (std::exp(-z_real_mm_ * kappa) + std::exp(-z_virtual_mm_ * kappa));
}

double Dipole::outer_mm() const { return reach_mm(sigma_tr_per_mm_, z_real_mm_); }

BetterDipole::BetterDipole(const optics::Medium& medium)
    : diffusion_(medium),
      z_real_mm_(1 / diffusion_.sigma_t_reduced_per_mm),
      z_virtual_mm_(z_real_mm_ + diffusion_.gap_mm) {}

double BetterDipole::at(double radius_mm) const {
  // [DE12]: R(r) = alpha'^2 (C_E E_n + C_phi phi). The two sources have opposite signs: their fluence
  // subtracts, and their flux adds, because they lie on opposite sides of the surface.
  const double s = diffusion_.sigma_tr_per_mm;
  const double flux = source_flux(z_real_mm_, radius_mm, s) + source_flux(z_virtual_mm_, radius_mm, s);
  const double fluence =
      source_fluence(z_real_mm_, radius_mm, s) - source_fluence(z_virtual_mm_, radius_mm, s);
  return diffusion_.reduced_albedo * diffusion_.reduced_albedo / (4 * pi) *
         (diffusion_.flux_part * flux + diffusion_.fluence_part / diffusion_.coefficient_mm * fluence);
}

double BetterDipole::hankel(double k_per_mm) const {
  // Exact, with the transforms of flux and fluence:
  //   R^(k) = alpha'^2/2 [ C_E (e^{-z_r kappa} + e^{-z_v kappa})
  //                        + C_phi / D (e^{-z_r kappa} - e^{-z_v kappa}) / kappa ]
  const double kappa = std::hypot(diffusion_.sigma_tr_per_mm, k_per_mm);
  const double real = std::exp(-z_real_mm_ * kappa), image = std::exp(-z_virtual_mm_ * kappa);

  // The last quotient stays finite for kappa -> 0.
  const double gap = z_virtual_mm_ - z_real_mm_;
  const double fluence = kappa > 0 ? real * -std::expm1(-gap * kappa) / kappa : gap;
  return diffusion_.reduced_albedo * diffusion_.reduced_albedo / 2 *
         (diffusion_.flux_part * (real + image) +
          diffusion_.fluence_part / diffusion_.coefficient_mm * fluence);
}

double BetterDipole::outer_mm() const { return reach_mm(diffusion_.sigma_tr_per_mm, z_real_mm_); }

}  // namespace dermis::profile
