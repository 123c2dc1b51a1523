// SPDX-License-Identifier: MIT
/// Source of a profile, as the skin panel offers it: those of `dermis profile`, and Gaussians drawn by hand.
#pragma once

#include <string>

#include "cli/profile_source.h"
#include "dermis/profile.h"

namespace dermis::viewer {

enum class SkinKind : std::uint8_t {
  scene,         ///< as the scene has it
  preset,        ///< a measured material
  spectral,      ///< melanin, haemoglobin and the rest
  coefficients,  ///< absorption and scattering per mm
  foreign,       ///< another engine's parameters, in its units
  gaussians      ///< a sum that was drawn by hand, or read from a file
};
inline constexpr const char* skin_kind_titles[] = {"as the scene has it", "a measured material",
                                                   "melanin and blood",   "coefficients",
                                                   "another engine's",    "Gaussians"};

struct SkinSource {
  SkinKind kind = SkinKind::scene;
  // Each of its kind; the others wait until their kind is chosen.
  std::string preset = "skin1";
  SpectralSkin spectral{};
  std::string colour{};     ///< "#rrggbb" that the spectral skin was found for; empty: none
  double colour_error = 0;  ///< CIE76 distance of that skin
  Coefficients coefficients{};
  std::string foreign{};       ///< as --import takes it
  ScatterProfile gaussians{};  ///< of SkinKind::gaussians
  ProfileOptions options{};
  std::uint64_t serial = 0;  ///< another one after each edit
};

/// Returns the options of `dermis profile` that name the same source. Not of SkinKind::scene and gaussians.
cli::SourceOptions source_options(const SkinSource& source);

}  // namespace dermis::viewer
