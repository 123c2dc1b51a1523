// SPDX-License-Identifier: MIT
// Skin as a stack of layers, from the surface down. Air above, and air below a last layer that ends.
// Based on: [DJ05] Donner, Jensen: Light Diffusion in Multi-Layered Translucent Materials. SIGGRAPH 2005
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "optics/media.h"

namespace dermis::optics {

/// One layer at one wavelength. Scattering is the reduced one, taken as isotropic.
struct Layer {
  double sigma_a_per_mm = 0;                                      ///< >= 0
  double sigma_s_reduced_per_mm = 0;                              ///< >= 0
  double eta = 1.4;                                               ///< 1 to 3, relative to air
  double thickness_mm = std::numeric_limits<double>::infinity();  ///< > 0 to 1e6; infinite only for the last

  /// The layer as a medium with g = 0.
  Medium medium() const {
    return {.sigma_a_per_mm = sigma_a_per_mm, .sigma_s_per_mm = sigma_s_reduced_per_mm, .g = 0, .eta = eta};
  }
};
using Layers = std::vector<Layer>;

/// One layer for three channels; geometry is common.
struct RgbLayer {
  Rgb sigma_a_per_mm{};
  Rgb sigma_s_reduced_per_mm{};
  double eta = 1.4;
  double thickness_mm = std::numeric_limits<double>::infinity();
};
using RgbLayers = std::vector<RgbLayer>;

inline constexpr std::size_t max_layers = 32;

/// Channel c (0..2) of a stack.
Layers channel(const RgbLayers& layers, int c);

/// 1 to 32 layers, ranges as above, an infinite thickness only at the bottom. InputError names the layer
/// (counted from 0).
void check(const Layers& layers, const std::string& where);

/// JSON list of {"sigma_a_per_mm", "sigma_s_reduced_per_mm", "eta", "thickness_mm"}; the coefficients are a
/// number or [R,G,B]; eta defaults to 1.4; thickness_mm may be left out (or null) in the last layer, which is
/// then a half-space. InputError: unknown key (lists the known ones), missing key, wrong type, out of range.
RgbLayers parse_layers(std::string_view json, const std::string& where);
/// The same from a file, whose name is the place; also InputError if it cannot be read.
RgbLayers load_layers(const std::filesystem::path& path);

}  // namespace dermis::optics
