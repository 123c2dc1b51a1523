// SPDX-License-Identifier: MIT
/// Options of an asset, whether it comes from a file or from arrays.
#pragma once

#include <memory>

#include "dermis/asset.h"
#include "head/scene/asset_data.h"
#include "head/scene/import/load_options.h"

namespace dermis::api {

/// Throws InputError: one is out of its range.
scene::LoadOptions load_options(const SceneOptions& options);

/// Returns whether the skin is to have other pigments than its colour map says.
bool changes_pigments(const SceneOptions& options);
/// Returns what has been imported with the pigments of the options, measured. Throws InputError: see
/// pigments::repaint(); too little memory.
std::shared_ptr<const scene::AssetData> finished(scene::AssetData&& asset, const SceneOptions& options = {});

}  // namespace dermis::api
