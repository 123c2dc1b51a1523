// SPDX-License-Identifier: MIT
// Parts of scenes made in memory. No device.
#pragma once

#include <glm/glm.hpp>

#include "head/scene/asset_data.h"

namespace dermis::tests {

/// A camera without perspective that looks along -z; `half_height_m` up and down. Sees what is a tenth of a
/// millimetre away.
scene::Camera camera_from_above(double half_height_m, const glm::vec3& position_m);

/// The same, 0.1 m from the origin, which it looks at from `angle_deg` off +z, towards +x.
scene::Camera camera_from_aside(double half_height_m, double angle_deg);

/// `irradiance` is that of a surface that faces the light.
scene::Light directional_light(const glm::vec3& direction, const glm::vec3& irradiance = glm::vec3(1));

/// Adds an opaque sheet, in a material of its own, over the half x > 0 of what lies below `z_m`: from 0 to
/// `size_m` along x, so far to both sides along y.
void add_sheet(scene::AssetData& made, float size_m, float z_m);

}  // namespace dermis::tests
