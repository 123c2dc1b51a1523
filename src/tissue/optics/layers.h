// SPDX-License-Identifier: MIT
// Skin as a stack of layers, from the surface down. Air lies above, and below a last layer of finite
// thickness.
// Based on: [DJ05] Donner, Jensen: Light Diffusion in Multi-Layered Translucent Materials. SIGGRAPH 2005
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tissue/optics/media.h"

namespace dermis::optics {

/// One layer at one wavelength. Scattering is reduced scattering, taken as isotropic.
struct Layer {
  double sigma_a_per_mm = 0;                                      ///< >= 0
  double sigma_s_reduced_per_mm = 0;                              ///< >= 0
  double eta = 1.4;                                               ///< 1 to 3, relative to air
  double thickness_mm = std::numeric_limits<double>::infinity();  ///< > 0 to 1e6; infinite only for the last

  /// Returns the layer as a medium with g = 0.
  Medium medium() const {
    return {.sigma_a_per_mm = sigma_a_per_mm, .sigma_s_per_mm = sigma_s_reduced_per_mm, .g = 0, .eta = eta};
  }
};
using Layers = std::vector<Layer>;

/// One layer for three channels, which share index and thickness.
struct RgbLayer {
  Rgb sigma_a_per_mm{};
  Rgb sigma_s_reduced_per_mm{};
  double eta = 1.4;
  double thickness_mm = std::numeric_limits<double>::infinity();
};
using RgbLayers = std::vector<RgbLayer>;

inline constexpr std::size_t max_layers = 32;

/// Returns channel c (0..2) of a stack.
Layers channel(const RgbLayers& layers, int c);

/// Throws InputError (names the layer, counted from 0) unless there are 1 to 32 layers within the ranges
/// above, with an infinite thickness at most in the last.
void check(const Layers& layers, const std::string& where);

/// Parses a JSON list of {"sigma_a_per_mm", "sigma_s_reduced_per_mm", "eta", "thickness_mm"}. Coefficients
/// are a number or [R,G,B]; eta defaults to 1.4; thickness_mm may be missing or null in the last layer, which
/// is then a half-space. Throws InputError for an unknown key (lists the known ones), a missing key, a wrong
/// type, a value out of range.
RgbLayers parse_layers(std::string_view text, const std::string& where);
/// Parses a file; throws InputError (place: its name) also if it cannot be read.
RgbLayers load_layers(const std::filesystem::path& path);

}  // namespace dermis::optics
