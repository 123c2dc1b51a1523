// SPDX-License-Identifier: MIT
// Scattering media: coefficients per mm and what follows from them, for one wavelength or one colour channel.
// Based on:
// [JMLH01] Jensen, Marschner, Levoy, Hanrahan: A Practical Model for Subsurface Light Transport.
//          SIGGRAPH 2001
// [CB15]   Christensen, Burley: Approximate Reflectance Profiles for Efficient Subsurface Scattering.
//          Pixar TM 15-04, 2015 (two meanings of a "radius")
#pragma once

#include <array>
#include <optional>
#include <string>

#include "dermis/profile.h"

namespace dermis::optics {

/// One value per colour channel: linear Rec.709 red, green, blue.
using Rgb = std::array<double, 3>;

/// Mean free path of the reduced medium, l_u = 1 / sigma_t' [mm], > 0: the mean distance between two
/// scatterings. A type of its own, because engines give a *diffuse* mean free path under the same name.
struct MeanFreePath {
  explicit MeanFreePath(double mm_) : mm(mm_) {}
  double mm;
};

/// Diffuse mean free path, l_d = 1 / sigma_tr [mm], > 0 (infinite without absorption): how far diffuse light
/// reaches.
struct DiffuseMeanFreePath {
  explicit DiffuseMeanFreePath(double mm_) : mm(mm_) {}
  double mm;
};

/// A homogeneous medium at one wavelength. Ranges and defaults are those of Coefficients.
struct Medium {
  double sigma_a_per_mm = 0;        ///< absorption coefficient
  double sigma_s_per_mm = 0;        ///< scattering coefficient
  double g = Coefficients().g;      ///< mean cosine of the phase function
  double eta = Coefficients().eta;  ///< refractive index relative to the air above

  /// sigma_s' = (1 - g) sigma_s [1/mm]. [JMLH01] sec. 2: forward scattering hardly changes the direction of
  /// light, so it counts less.
  double sigma_s_reduced_per_mm() const { return (1 - g) * sigma_s_per_mm; }
  /// sigma_t' = sigma_a + sigma_s' [1/mm]. [JMLH01] sec. 2.
  double sigma_t_reduced_per_mm() const { return sigma_a_per_mm + sigma_s_reduced_per_mm(); }
  /// sigma_t = sigma_a + sigma_s [1/mm].
  double sigma_t_per_mm() const { return sigma_a_per_mm + sigma_s_per_mm; }
  /// alpha' = sigma_s' / sigma_t', 0 to 1. [JMLH01] sec. 2. Diffusion theory needs it near 1.
  double reduced_albedo() const { return sigma_s_reduced_per_mm() / sigma_t_reduced_per_mm(); }
  /// D = 1 / (3 sigma_t') [mm]. [JMLH01] sec. 2.1.
  double diffusion_coefficient_mm() const { return 1 / (3 * sigma_t_reduced_per_mm()); }
  /// sigma_tr = sqrt(3 sigma_a sigma_t') = sqrt(sigma_a / D) [1/mm]. [JMLH01] sec. 2.1.
  double sigma_tr_per_mm() const;
  /// l_u = 1 / sigma_t'.
  MeanFreePath mean_free_path() const { return MeanFreePath(1 / sigma_t_reduced_per_mm()); }
  /// l_d = 1 / sigma_tr; infinite where sigma_a = 0.
  DiffuseMeanFreePath diffuse_mean_free_path() const { return DiffuseMeanFreePath(1 / sigma_tr_per_mm()); }
};

/// A medium per colour channel.
using RgbMedium = std::array<Medium, 3>;

/// Returns the same coefficients as a medium per channel, and the reverse: none if channels differ in g or
/// eta.
RgbMedium rgb_medium(const Coefficients& coefficients);
std::optional<Coefficients> coefficients_of(const RgbMedium& medium);

/// Throws InputError (place `where`) unless all values are in their ranges and sigma_t' > 0.
void check(const Medium& medium, const std::string& where);
/// Checks each channel; the message names it.
void check(const RgbMedium& medium, const std::string& where);

/// Parses "sigma_a=0.03,0.17,0.48 sigma_s=0.74,0.88,1.01 g=0 eta=1.4": coefficients per mm, each one number
/// or three (R,G,B). sigma_a and sigma_s are required; defaults are g = 0 and eta = 1.4. Throws InputError
/// for an unknown or repeated key (lists the known ones), a value that is no number or out of range.
RgbMedium parse_coefficients(const std::string& text, const std::string& where);

}  // namespace dermis::optics
