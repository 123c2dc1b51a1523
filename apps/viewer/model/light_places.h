// SPDX-License-Identifier: MIT
/// Lights as a hand moves them: around the heads, by azimuth, elevation and what arrives (PlacedLight), in
/// their own colour, at their own distance.
#pragma once

#include <array>

#include "viewer/model/camera_moves.h"

namespace dermis::viewer {

/// Returns where the light stands, seen from the centre of the sphere, and the greatest channel of the
/// irradiance there. `sphere`: in the light's coordinates.
PlacedLight place_of(const Light& light, const HeadSphere& sphere);

/// Returns the light at another place, at its distance and with its colour, aimed at the centre.
Light placed(const Light& light, const PlacedLight& at, const HeadSphere& sphere);

/// Returns its colour, whose greatest channel is 1.
std::array<double, 3> tone_of(const Light& light);
/// Returns the light in another colour; its greatest channel stays.
Light with_tone(const Light& light, const std::array<double, 3>& tone);

/// Returns the sphere in the coordinates of a light's rig; as it is without one.
HeadSphere in_rig(const HeadSphere& sphere, const Scene& scene, const SceneLight& light);

/// Returns whether the lights that are drawn are those of the scene: none of the settings replace them.
bool draws_scene_lights(const Document& document);

/// Puts the lights that are drawn into the scene, and takes those of the settings away, so that each can be
/// edited. The picture stays.
void own_lights(Document& document);

/// Adds a white spot of the rig at this place, and returns it.
LightId add_lamp(Document& document, const PlacedLight& at);

}  // namespace dermis::viewer
