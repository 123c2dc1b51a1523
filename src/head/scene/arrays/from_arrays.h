// SPDX-License-Identifier: MIT
// Makes scenes from the arrays of a host.
#pragma once

#include "dermis/asset_arrays.h"
#include "head/scene/asset_data.h"
#include "head/scene/import/load_options.h"

namespace dermis::scene {

/// Makes the scene that a glTF file with the same content gives, without lights and cameras. Reads the spans
/// while it runs, copies what it keeps. Warns (base/core/log.h) and counts steps (base/core/hooks.h) as
/// load_gltf() does, naming the asset in place of a file. Throws InputError for all that
/// dermis/asset_arrays.h excludes, before memory is taken; Cancelled if its caller ends it.
AssetData scene_from_arrays(const AssetArrays& arrays, const LoadOptions& options = {});

}  // namespace dermis::scene
