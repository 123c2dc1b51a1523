// SPDX-License-Identifier: MIT
// Maps whose texture coordinates a mesh lacks. glTF calls such a file an error; as other viewers do, the maps
// are left out for that mesh.
#pragma once

#include "scene/gltf/document.h"
#include "scene/gltf/place.h"

namespace dermis::scene::gltf {

/// Gives each primitive that lacks coordinates which a map of its material is read with a copy of the
/// material without such maps: light map, picture and reference then agree. Materials are changed, or
/// appended to `scene`. Warns, once for each kind.
void leave_out_maps_without_uv(const Document& document, const Placed& placed, Scene& scene);

}  // namespace dermis::scene::gltf
