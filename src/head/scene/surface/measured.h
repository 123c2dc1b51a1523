// SPDX-License-Identifier: MIT
/// Measures of an asset that frames need, whatever their settings.
#pragma once

#include <memory>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Returns the asset with its skin as meshes with an unwrap, their densities, and bounds. Each import of the
/// api ends with this.
std::shared_ptr<const AssetData> measured(AssetData asset);

}  // namespace dermis::scene
