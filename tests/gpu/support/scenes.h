// SPDX-License-Identifier: MIT
// Scenes made in memory, and parts of them.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "dermis/scene.h"
#include "head/scene/asset_data.h"
#include "support/scenes.h"

namespace dermis::tests {

/// A scene made in memory.
Scene wrap(scene::AssetData data);

/// Six charts, radius in metres.
Scene sphere(double radius_m);
Scene sheared_plane();

/// The sphere under one directional light that shines where the framing camera looks.
Scene sphere_lit_from_the_camera(double radius_m);

/// A square of skin in the plane z = 0, and a second one of the same size that `place` puts elsewhere: one
/// mesh of two charts. The vertices of the second stand behind those of the first.
scene::AssetData two_planes(double side_m, int cells, const std::function<void(scene::Vertex&)>& place);

}  // namespace dermis::tests
