// SPDX-License-Identifier: MIT
/// What the settings leave open, decided in one place for pictures and for the reference: camera, lights,
/// profile.
#pragma once

#include <vector>

#include "dermis/settings.h"
#include "gaussians/sum.h"
#include "scene/scene.h"

namespace dermis::setup {

/// Returns the camera that the settings name or describe, else the first of the scene, else one that frames
/// `sphere`, the bounds of the skin. Throws InputError if none has that name; lists those of the scene.
scene::Camera choose_camera(const scene::Scene& scene, const RenderSettings& settings,
                            const scene::BoundingSphere& sphere);

/// Returns the lights that the settings place, else the scene's, or the rig around the sphere and
/// `head_offsets_m`.
std::vector<scene::Light> choose_lights(const scene::Scene& scene, const RenderSettings& settings,
                                        const scene::BoundingSphere& sphere,
                                        const std::vector<glm::vec3>& head_offsets_m);

/// Returns the settings' profile, else the material's, else the published six Gaussians.
gaussians::SumOfGaussians choose_profile(const scene::Material& material, const RenderSettings& settings);

}  // namespace dermis::setup
