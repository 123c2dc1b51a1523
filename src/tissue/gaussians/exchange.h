// SPDX-License-Identifier: MIT
// A profile in the parameters of other systems, and back. Each convention is
// taken from that system's own source or documentation; docs/exports.md cites them line by line. The output
// says what a system cannot hold ("lost").
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tissue/gaussians/sum.h"
#include "tissue/optics/media.h"
#include "tissue/profile/radial.h"

namespace dermis::gaussians {

/// "separable", "unity", "unreal", "gltf", "openpbr", "cycles".
std::vector<std::string_view> exchange_names();

/// Input of an export.
struct Exported {
  std::string name;
  std::array<profile::ProfilePtr, 3> profiles;
  /// {variance_mm2, weight} per channel, weights summing to 1
  std::array<std::vector<std::array<double, 2>>, 3> terms;
  optics::RgbMedium medium;  ///< the medium, or the equivalent one
};

/// JSON with "system", "parameters" (that system's own names), "units", "lost". Lengths that are Burley's d
/// are chosen so that R^ falls to half at the same frequency as the profile's. InputError: unknown system
/// (lists the known ones).
std::string export_text(std::string_view system, const Exported& input);

/// Result of an import: a Burley profile per channel, or a medium.
struct Imported {
  std::string name;
  optics::Rgb total_reflectance{};
  optics::Rgb burley_shape_mm{};  ///< > 0 if the system describes Burley profiles
  optics::RgbMedium medium{};     ///< else
  bool is_burley = false;
};

/// "SYSTEM key=R,G,B key=...", e.g. "unity reflectance=0.8,0.5,0.4 scattering_distance=0.76,0.32,0.2".
/// InputError: unknown system or key (lists them), and every text whose unit or meaning is open. Its message
/// then names the readings it could have, with the length that each would give.
Imported parse_import(const std::string& text, const std::string& where);

}  // namespace dermis::gaussians
