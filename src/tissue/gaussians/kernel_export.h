// SPDX-License-Identifier: MIT
// The kernels of techniques in screen space, and the tables of pre-integrated scattering, for other
// renderers: as JSON, as arrays of C and GLSL, and as pictures. docs/exports.md says how they are used.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tissue/gaussians/sum.h"

namespace dermis::gaussians {

/// "separable-kernel", "burley-disc", "pre-integrated-tables".
std::vector<std::string_view> kernel_names();

/// A picture of numbers.
struct KernelPicture {
  std::string name;                         ///< "taps": what of the kernel it holds
  int width = 0, height = 0, channels = 3;  ///< 3 or 4
  std::vector<float> values;
};

struct ExportedKernel {
  std::string json, c, glsl;  ///< whole files
  std::vector<KernelPicture> pictures;
};

/// Throws InputError if the kernel cannot have so many taps.
void check_kernel_taps(std::string_view kernel, std::optional<int> taps);

/// Returns the kernel of the profile. taps: of the kernel, as many as the technique usually has if it is not
/// given. Throws InputError: an unknown kernel (lists them), or a number of taps that it cannot have.
ExportedKernel export_kernel(std::string_view kernel, const ScatterProfile& profile, std::optional<int> taps);

}  // namespace dermis::gaussians
