// SPDX-License-Identifier: MIT
/// The end of every import.
#pragma once

#include <memory>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Returns the asset with what frames need of it, whatever their settings: its skin as meshes with an unwrap,
/// bounds, densities. Warns of unwraps that overlap.
std::shared_ptr<const AssetData> measured(AssetData asset);

}  // namespace dermis::scene
