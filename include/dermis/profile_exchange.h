// SPDX-License-Identifier: MIT
/// Profiles in the parameters of other renderers, kernels for them, and profiles of what others have: tables,
/// parameters, colours. docs/exports.md cites each convention.
///
///   const dermis::ScatterProfile p = dermis::profile_of_skin({.melanin = 0.05});
///   std::cout << dermis::export_profile(p, "cycles");   // Blender
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "dermis/profile.h"

namespace dermis {

/// Returns "separable", "unity", "unreal", "gltf", "openpbr", "cycles".
std::vector<std::string> exchange_systems();

/// Returns JSON: "system", "parameters" under that system's own names, "units", "lost" (what it cannot hold).
/// Gaussians are the curve of a profile that was read. Throws InputError: an unknown system (lists
/// them), what check_profile() refuses.
std::string export_profile(const ScatterProfile& profile, const std::string& system);

/// The kernel of a technique as whole files.
struct ProfileKernel {
  std::string json, c, glsl;
};
/// Returns "separable-kernel", "burley-disc", "pre-integrated-tables".
std::vector<std::string> kernel_names();
/// Returns the kernel of the profile. `taps`: none: as many as usual. Throws InputError: an unknown kernel
/// (lists them), taps that it cannot have.
ProfileKernel export_kernel(const ScatterProfile& profile, const std::string& kernel,
                            std::optional<int> taps = {});

/// Fits R(r) at rising radii, mm, at least 2: linear between them, constant before the first, 0 after the
/// last; `reflectance_per_mm2`: as many, at least 0. Of ProfileOptions counts what concerns the fit. Throws
/// InputError: radii that do not rise, a value below 0, a total over 1.
ScatterProfile profile_of_table(const std::string& name, const std::vector<double>& r_mm,
                                const std::vector<std::array<double, 3>>& reflectance_per_mm2,
                                const ProfileOptions& options = {}, const Hooks& hooks = {});
/// Reads parameters of another system: "unity reflectance=0.8,0.5,0.4 scattering_distance=0.76,0.32,0.2".
/// Throws InputError for an unknown system or key (lists them) and for text whose unit is open (names its
/// readings).
ScatterProfile profile_of_import(const std::string& text, const ProfileOptions& options = {},
                                 const Hooks& hooks = {});

}  // namespace dermis
