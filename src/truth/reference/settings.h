// SPDX-License-Identifier: MIT
// Input of the reference: a scene, with the camera and lights of the real-time
// techniques.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "dermis/reference.h"
#include "head/scene/asset_data.h"
#include "tissue/gaussians/sum.h"
#include "tissue/optics/media.h"
#include "truth/reference/environment_sampler.h"

namespace dermis::reference {

struct RenderSetup {
  scene::Camera camera;
  int width = 0, height = 0;  ///< pixels, >= 1
  std::vector<scene::Light> lights;
  double ambient = 0;                                     ///< uniform radiance from everywhere
  std::shared_ptr<const EnvironmentSampler> environment;  ///< replaces `ambient`
  double radiance_scale = 1;                              ///< 2^EV
  bool specular = true, white_albedo = false;
  std::optional<double> mix;  ///< overrides that of the materials
};

struct Job {
  RenderSetup setup;
  ReferenceModel model = ReferenceModel::bssrdf;
  /// bssrdf, gaussians: one per material of the scene; empty for materials that are not skin. Of gaussians,
  /// the first term may have a variance of 0.
  std::vector<ScatterProfile> profiles;
  optics::RgbMedium medium{};  ///< volume; one g and one eta for all channels
};

}  // namespace dermis::reference
