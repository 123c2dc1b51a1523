// SPDX-License-Identifier: MIT
#include "tissue/optics/skin.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "tissue/optics/fresnel.h"

namespace dermis::optics {
namespace {

struct HaemoglobinRow {
  double nm, oxy, deoxy;
};
constexpr HaemoglobinRow haemoglobin[] = {
#include "tissue/optics/haemoglobin.inc"
};

/// Returns the extinction, linear between samples.
double extinction(double nm, double HaemoglobinRow::*column) {
  DERMIS_ASSERT(nm >= haemoglobin[0].nm && nm <= std::end(haemoglobin)[-1].nm);
  const double step = haemoglobin[1].nm - haemoglobin[0].nm, position = (nm - haemoglobin[0].nm) / step;
  const std::size_t i = std::min(static_cast<std::size_t>(position), std::size(haemoglobin) - 2);
  const double part = position - static_cast<double>(i);
  return haemoglobin[i].*column * (1 - part) + haemoglobin[i + 1].*column * part;
}

constexpr double grams_per_litre = 150, grams_per_mol = 64500, per_cm_to_per_mm = 0.1;

double blood_per_mm(double extinction_per_cm_molar) {
  return std::numbers::ln10 * extinction_per_cm_molar * grams_per_litre / grams_per_mol * per_cm_to_per_mm;
}

}  // namespace

double eumelanin_per_mm(double nm) { return 6.6e10 * std::pow(nm, -3.33); }
double pheomelanin_per_mm(double nm) { return 2.9e14 * std::pow(nm, -4.75); }
double baseline_per_mm(double nm) { return 0.0244 + 8.53 * std::exp(-(nm - 154) / 66.2); }
double oxyhaemoglobin_per_mm(double nm) { return blood_per_mm(extinction(nm, &HaemoglobinRow::oxy)); }
double deoxyhaemoglobin_per_mm(double nm) { return blood_per_mm(extinction(nm, &HaemoglobinRow::deoxy)); }
double skin_scattering_per_mm(double nm) { return 14.74 * std::pow(nm, -0.22) + 2.2e11 * std::pow(nm, -4); }

Layers skin_layers(const SpectralSkin& skin, double nm) {
  const double base = baseline_per_mm(nm), scattering = skin_scattering_per_mm(nm);

  // [DJ06] eq. 1 to 6, with C_m melanin, beta blend, C_h haemoglobin, gamma oxygenation:
  //   epidermis sigma_a = C_m (beta eu + (1 - beta) pheo) + (1 - C_m) base,
  //   dermis    sigma_a = C_h (gamma oxy + (1 - gamma) deoxy) + (1 - C_h) base.
  const double melanin = skin.blend * eumelanin_per_mm(nm) + (1 - skin.blend) * pheomelanin_per_mm(nm);
  const double blood =
      skin.oxygenation * oxyhaemoglobin_per_mm(nm) + (1 - skin.oxygenation) * deoxyhaemoglobin_per_mm(nm);

  const Layer epidermis{.sigma_a_per_mm = skin.melanin * melanin + (1 - skin.melanin) * base,
                        .sigma_s_reduced_per_mm = scattering,
                        .eta = skin_eta,
                        .thickness_mm = skin.epidermis_mm};
  const Layer dermis{.sigma_a_per_mm = skin.haemoglobin * blood + (1 - skin.haemoglobin) * base,
                     .sigma_s_reduced_per_mm = 0.5 * scattering,
                     .eta = skin_eta,
                     .thickness_mm = std::numeric_limits<double>::infinity()};
  return {epidermis, dermis};
}

double entering_part() { return 1 - skin_oiliness * fresnel_moment_2c1(1 / skin_eta); }

}  // namespace dermis::optics
