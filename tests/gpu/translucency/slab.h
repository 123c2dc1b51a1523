// SPDX-License-Identifier: MIT
// Slabs of skin lit from behind, whose light in the middle is known in closed form.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "dermis/settings.h"
#include "head/scene/asset_data.h"

namespace dermis::tests {

/// Front z = 0 with normal +z, back z = -thickness, both 40 mm wide, each a chart of its own; seen from +z
/// without perspective, 1 mm up and down. `skin` is material 0.
scene::AssetData slab(double thickness_mm);

/// A directional light that falls on the back at this angle to its normal; irradiance facing it.
scene::Light from_behind(const glm::vec3& irradiance, double angle_deg = 0);
/// A spot and a point light on the axis, 0.6 m and 0.3 m behind the front.
scene::Light spot_behind(const glm::vec3& intensity);
scene::Light point_behind(const glm::vec3& intensity);

/// White skin, nothing but the scene's lights, no reflection.
RenderSettings slab_settings();

/// What a slab shows over its lit side's radiance B: sum_i w_i exp(-d^2 / 2 v_i) of the six Gaussians of
/// skin.
std::array<double, 3> slab_factor(double thickness_mm);

}  // namespace dermis::tests
