// SPDX-License-Identifier: MIT
/// Files of assets, beyond what a scene keeps of them.
#pragma once

#include "base/core/hash.h"
#include "dermis/scene.h"

namespace dermis::api {

/// Adds the bytes of the files that the assets of a scene were loaded from, with the buffers beside a .gltf.
/// That is all that may show at some time of a clip, but for maps. Throws InputError: one cannot be read.
void add_asset_files(Hash& hash, const Scene& scene);

}  // namespace dermis::api
