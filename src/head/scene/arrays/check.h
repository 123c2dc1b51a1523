// SPDX-License-Identifier: MIT
// Holds the arrays of a host against what include/dermis/asset_arrays.h says of them. Takes no memory that
// grows with them.
#pragma once

#include <string>

#include "dermis/asset_arrays.h"
#include "head/scene/import/load_options.h"

namespace dermis::scene::arrays {

/// Names the asset in messages: its name on one line, else "asset".
std::string name_of(const AssetArrays& arrays);

// Throw InputError for the first fault: asset, mesh (material, image), member, what was expected, what was
// given.
void check_images(const AssetArrays& arrays, const LoadOptions& options);
void check_materials(const AssetArrays& arrays);
void check_meshes(const AssetArrays& arrays, const LoadOptions& options);

/// Names one object in messages: "mesh 2 'face'".
std::string place_of(const char* kind, std::size_t number, const std::string& name);

/// Returns the number of triangles of a mesh.
std::size_t triangles_of(const AssetMesh& mesh);

}  // namespace dermis::scene::arrays
