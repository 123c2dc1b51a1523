// SPDX-License-Identifier: MIT
// What the reference renders: a scene, seen and lit as the real-time techniques see and light it.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "gaussians/sum.h"
#include "optics/media.h"
#include "reference/environment_sampler.h"
#include "scene/scene.h"

namespace dermis::reference {

/// bssrdf: the profile, integrated over the surface. volume: light followed through the medium under it.
enum class Model { bssrdf, volume };

struct RenderSetup {
  scene::Camera camera;
  int width = 0, height = 0;  ///< pixels, >= 1
  std::vector<scene::Light> lights;
  double ambient = 0;                                     ///< uniform radiance from everywhere
  std::shared_ptr<const EnvironmentSampler> environment;  ///< a picture of them instead
  double radiance_scale = 1;                              ///< 2^EV
  bool specular = true, white_albedo = false;
  std::optional<double> mix;  ///< overrides the materials'
};

struct Job {
  RenderSetup setup;
  Model model = Model::bssrdf;
  /// bssrdf: one per material of the scene; those that are not skin may be empty
  std::vector<gaussians::SumOfGaussians> profiles;
  optics::RgbMedium medium{};  ///< volume; one g and one eta for all channels
};

}  // namespace dermis::reference
