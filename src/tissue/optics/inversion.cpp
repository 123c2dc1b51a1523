// SPDX-License-Identifier: MIT
#include "tissue/optics/inversion.h"

#include <cmath>

#include "base/core/error.h"
#include "tissue/optics/fresnel.h"

namespace dermis::optics {
namespace {

void check_length(double mm, const char* name, const std::string& where) {
  if (!(mm > 0 && std::isfinite(mm)))
    throw input_error(where, "{} must be above 0 mm and finite, got {}", name, mm);
}

Medium medium_of(double reduced_albedo, double sigma_t_reduced_per_mm, double eta, const std::string& where) {
  Medium medium;
  medium.sigma_s_per_mm = reduced_albedo * sigma_t_reduced_per_mm;
  medium.sigma_a_per_mm = (1 - reduced_albedo) * sigma_t_reduced_per_mm;
  medium.eta = eta;
  check(medium, where);
  return medium;
}

}  // namespace

double dipole_total_reflectance(double reduced_albedo, double eta) {
  // [JMLH01] eq. 15: R_d = (alpha'/2) (1 + e^{-(4/3) A sqrt(3 (1 - alpha'))}) e^{-sqrt(3 (1 - alpha'))}.
  const double root = std::sqrt(3 * (1 - reduced_albedo));
  return reduced_albedo / 2 * (1 + std::exp(-4.0 / 3 * boundary_factor_classical(eta) * root)) *
         std::exp(-root);
}

double reduced_albedo_from_reflectance(double total_reflectance, double eta, const std::string& where) {
  if (!(total_reflectance >= 0 && total_reflectance <= 1))
    throw input_error(where, "reflectance must be 0 to 1, got {}", total_reflectance);
  if (!(eta >= 1 && eta <= 3)) throw input_error(where, "eta must be 1 to 3, got {}", eta);
  // Bisection: R_d grows with alpha'.

  double low = 0, high = 1;
  if (total_reflectance == 1) return 1;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (dipole_total_reflectance(middle, eta) < total_reflectance ? low : high) = middle;
  }
  return (low + high) / 2;
}

Medium medium_from_reflectance(double total_reflectance, MeanFreePath length, double eta,
                               const std::string& where) {
  check_length(length.mm, "mean free path", where);
  return medium_of(reduced_albedo_from_reflectance(total_reflectance, eta, where), 1 / length.mm, eta, where);
}

Medium medium_from_reflectance(double total_reflectance, DiffuseMeanFreePath length, double eta,
                               const std::string& where) {
  check_length(length.mm, "diffuse mean free path", where);
  const double albedo = reduced_albedo_from_reflectance(total_reflectance, eta, where);
  if (albedo >= 1)
    throw input_error(where,
                      "reflectance 1 means no absorption, whose diffuse mean free path is infinite: give a "
                      "mean free path, or a reflectance below 1");
  return medium_of(albedo, 1 / (length.mm * std::sqrt(3 * (1 - albedo))), eta, where);
}

}  // namespace dermis::optics
