// SPDX-License-Identifier: MIT
// Materials of a host in the form that all sources share. Arguments have passed arrays/check.h.
#pragma once

#include "dermis/asset_arrays.h"
#include "head/scene/import/material_source.h"

namespace dermis::scene::arrays {

/// Returns the material; its maps name images by their number in AssetArrays.
MaterialSource read_material(const AssetMaterial& given);

}  // namespace dermis::scene::arrays
