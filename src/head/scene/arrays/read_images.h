// SPDX-License-Identifier: MIT
// Images of a host: those that the materials use, as large as the budget allows.
#pragma once

#include <cstdint>

#include "dermis/asset_arrays.h"
#include "head/scene/asset_data.h"

namespace dermis::scene::arrays {

/// Copies the images that the scene's materials use and points the maps at AssetData::images, as
/// decode_images() does for a file. Over the budget (of map_bytes()) the largest are halved, with a note.
/// Images have passed arrays/check.h. Throws InputError if they cannot fit, or if memory runs out.
void read_images(const AssetArrays& arrays, std::uint64_t budget_bytes, AssetData& scene);

}  // namespace dermis::scene::arrays
