// SPDX-License-Identifier: MIT
// A character with a second clip, which no file of the shared assets has.
#pragma once

#include "../gltf/support.h"

namespace dermis::scene::test {

/// Writes a copy of a .glb with one buffer, one skin and one mesh to `to`, with a clip "second" of 2 s more:
/// the second joint of the skin turns, and all morph weights rise. Returns `to`.
fs::path with_second_clip(const fs::path& file, const fs::path& to);

}  // namespace dermis::scene::test
