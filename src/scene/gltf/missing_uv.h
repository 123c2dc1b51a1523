// SPDX-License-Identifier: MIT
// Handles maps whose texture coordinates a mesh lacks. glTF calls such a file an error; as other viewers do,
// we leave out these maps for that mesh.
#pragma once

#include "scene/gltf/document.h"
#include "scene/gltf/place.h"

namespace dermis::scene::gltf {

/// Gives each primitive that lacks coordinates for a map of its material a copy of the material without such
/// maps, so that light map, picture and reference agree. Changes materials or appends to them. Warns, once
/// per kind.
void leave_out_maps_without_uv(const Document& document, const Placed& placed, Scene& scene);

}  // namespace dermis::scene::gltf
