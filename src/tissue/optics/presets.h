// SPDX-License-Identifier: MIT
// Published measurements of media.
// Based on:
// [JMLH01] fig. 5 (measured coefficients)
// [DJ05]   Donner, Jensen: Light Diffusion in Multi-Layered Translucent Materials. SIGGRAPH 2005
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tissue/optics/layers.h"
#include "tissue/optics/media.h"

namespace dermis::optics {

/// A measured homogeneous material: reduced coefficients (given as sigma_s with g = 0), per mm.
struct Material {
  std::string_view name;  ///< lower case, as presets are asked for
  Rgb sigma_s_reduced_per_mm;
  Rgb sigma_a_per_mm;
  /// 1.3; marble 1.5. Not printed in the table, but these values reproduce the printed reflectances to 0.01.
  double eta;
  Rgb published_reflectance;  ///< column "diffuse reflectance" of [JMLH01] fig. 5

  /// Returns the coefficients per channel [1/mm], scattering as reduced (g = 0).
  RgbMedium medium() const;
};

/// Returns the twelve materials of [JMLH01] fig. 5, in its order.
std::span<const Material> jensen_materials();

/// Returns the layered preset "skin-layers", the three-layer skin of [DJ05] in RGB. Its source gives no unit;
/// we read 1/cm, for which the epidermis has a plausible mean free path of 0.2 mm. Thicknesses 0.25 mm, 0.35
/// mm and a half-space are our assumption. It is plausible skin, but not the source of the published six
/// Gaussians: no thicknesses reproduce those.
RgbLayers donner_jensen_skin();

/// Returns the names of all presets, layered ones last, for listings and errors.
std::vector<std::string_view> preset_names();
/// Returns a homogeneous material by name, or nullptr.
const Material* find_material(std::string_view name);
/// Throws InputError that lists preset_names().
[[noreturn]] void unknown_preset(std::string_view name);

}  // namespace dermis::optics
