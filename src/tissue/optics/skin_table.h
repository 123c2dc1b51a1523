// SPDX-License-Identifier: MIT
// The colour of spectral skin by a table, and the skin of a colour: for maps, where each texel asks.
// Based on: [JSB10] Jimenez, Scully, Barbosa et al.: A Practical Appearance Model for Dynamic Facial Color.
// ACM Transactions on Graphics 29(6), 2010 (a table over melanin and haemoglobin); [PGW93] for the totals
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tissue/optics/observer.h"
#include "tissue/optics/skin.h"

namespace dermis::optics {

/// Pigments differ from texel to texel; all else of a skin is fixed.
struct Pigments {
  double melanin = 0.02;      ///< volume fraction in the epidermis, least_melanin to most_melanin
  double haemoglobin = 0.01;  ///< volume fraction of blood in the dermis, least_blood to most_blood
  double oxygenation = 0.75;  ///< 0 to 1; matters where the table has several
};

/// Ranges of tables. Measured skin lies inside them; the colour hardly changes below.
inline constexpr double least_melanin = 5e-4, most_melanin = 0.5, least_blood = 5e-4, most_blood = 0.1;

/// skin_reflectance() over melanin, haemoglobin and oxygenation: what an albedo map holds, linear Rec.709.
class SkinTable {
 public:
  /// Computes the table: totals with 8 directions at 41 wavelengths, 40 melanins x 24 haemoglobins, evenly in
  /// their logarithms. `oxygenations`: 1 to 8, rising, 0 to 1, evenly apart. About 0.2 s per oxygenation on
  /// one core. Equal input gives equal bits. Throws InputError if `fixed` is out of range.
  explicit SkinTable(const SpectralSkin& fixed, const std::vector<double>& oxygenations);
  /// Of the oxygenation of `fixed`.
  explicit SkinTable(const SpectralSkin& fixed) : SkinTable(fixed, {fixed.oxygenation}) {}

  const SpectralSkin& fixed() const { return fixed_; }

  /// Interpolates the logarithm of the reflectance, linear in the logarithms of the fractions. Values out of
  /// the table's ranges are clamped.
  std::array<float, 3> at(const Pigments& pigments) const;

  /// A skin found for an albedo.
  struct Match {
    Pigments pigments;
    double delta_e = 0;  ///< CIE76 between both albedos
  };
  /// Finds melanin and haemoglobin of the nearest albedo in CIE76, for this oxygenation: the nearest node of
  /// the table, then damped Gauss-Newton within the table. Takes some 10 us.
  Match nearest(const Rgb& albedo, double oxygenation) const;
  Match nearest(const Rgb& albedo) const { return nearest(albedo, fixed_.oxygenation); }

 private:
  static constexpr std::size_t melanins = 40, bloods = 24;
  /// Places in the table, 0 to the number of nodes less 1.
  struct Place {
    double melanin = 0, blood = 0, oxygenation = 0;
  };
  Place place_of(const Pigments& pigments) const;
  Pigments pigments_at(const Place& place, double oxygenation) const;
  std::array<float, 3> at(const Place& place) const;
  Lab lab_at(const Place& place) const;
  std::size_t node(std::size_t melanin, std::size_t blood, std::size_t oxygenation) const {
    return (oxygenation * bloods + blood) * melanins + melanin;
  }

  SpectralSkin fixed_;
  std::vector<double> oxygenations_;
  std::vector<std::array<float, 3>> log_reflectance_;  ///< by node()
  std::vector<Lab> labs_;                              ///< likewise
};

}  // namespace dermis::optics
