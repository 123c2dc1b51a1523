// SPDX-License-Identifier: MIT
/// Decides, for pictures and for the reference, what the settings leave open: camera, lights, profile.
#pragma once

#include <vector>

#include "dermis/settings.h"
#include "render/setup/placed_scene.h"
#include "tissue/gaussians/json.h"
#include "tissue/gaussians/sum.h"

namespace dermis::setup {

/// Returns the camera that the settings name or describe, else the first of a scene of one instance, else one
/// that frames the heads. Throws InputError if none has that name; lists those of the scene.
scene::Camera choose_camera(const PlacedScene& scene, const RenderSettings& settings,
                            const HeadSpheres& spheres);

/// Returns the lights that the settings place, else the scene's, or the rig around the heads.
std::vector<scene::Light> choose_lights(const PlacedScene& scene, const RenderSettings& settings,
                                        const HeadSpheres& spheres);

/// Gives all instances the profile that the settings name, if they name one. Reads its file, which set_up()
/// does not. Variances may be 0.
void take_profile(PlacedScene& scene, const RenderSettings& settings);

/// Returns the instance's profile, else the material's, else the published six Gaussians.
ScatterProfile choose_profile(const scene::Material& material,
                              const std::optional<ScatterProfile>& of_instance);

/// Returns the settings' profile, else as above. Reads its file. `least`: of the settings' profile.
ScatterProfile choose_profile(const scene::Material& material, const RenderSettings& settings,
                              const std::optional<ScatterProfile>& of_instance = {},
                              gaussians::LeastVariance least = gaussians::LeastVariance::above_zero);

}  // namespace dermis::setup
