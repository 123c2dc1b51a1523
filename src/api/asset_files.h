// SPDX-License-Identifier: MIT
/// What a scene does not keep of the files that its assets were loaded from.
#pragma once

#include <string>

#include "core/hash.h"
#include "dermis/scene.h"

namespace dermis::api {

/// Adds the bytes of the files that the assets of a scene were loaded from, with the buffers beside a .gltf:
/// all that may show at some time of a clip, but for maps. Throws InputError: one cannot be read.
void add_asset_files(Hash& hash, const Scene& scene);

/// Returns the time of the last key frame of a clip, seconds; of several assets the latest. Empty: of the
/// first clip of each. Throws InputError: an asset has no such clip (lists those it has), or is of no file.
double clip_end_s(const Scene& scene, const std::string& clip);

}  // namespace dermis::api
