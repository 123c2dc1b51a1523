// SPDX-License-Identifier: MIT
// The quality settings of techniques: what each can trade error against cost by.
#pragma once

#include <string>
#include <vector>

#include "dermis/renderer.h"

namespace dermis::api {

/// One setting of one technique.
struct QualitySetting {
  std::string curve;  ///< whose points belong together: "separable, published kernel"
  std::string label;  ///< "25 taps", "map of 1024"
  RenderSettings settings;
};

/// Returns the settings of a technique from cheap to dear, as far as it can draw the scene with them. They
/// are taps of each kernel at full and half resolution, sizes of light maps. One point of a technique that
/// has none of these.
std::vector<QualitySetting> quality_settings(const Scene& scene, const RenderSettings& common,
                                             const std::string& technique);

}  // namespace dermis::api
