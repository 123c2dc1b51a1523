// SPDX-License-Identifier: MIT
/// Loads glTF files. Every limit is checked before memory is taken; any fault ends in one InputError that
/// names file and place.
#pragma once

#include <filesystem>

#include "head/scene/asset_data.h"
#include "head/scene/import/load_options.h"

namespace dermis::scene {

/// Loads glTF 2.0, .gltf or .glb. Makes missing normals and tangents (head/scene/surface/tangents.h). Warns
/// (base/core/log.h) and counts steps (base/core/hooks.h): throws Cancelled if its caller ends it.
AssetData load_gltf(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace dermis::scene
