// SPDX-License-Identifier: MIT
#pragma once
#include "base/core/cache.h"
#include "head/builtin_head/builtin_head.h"

namespace dermis::tests {

/// Returns the built-in head from the folder of kept files that all tests of a build share
/// (cmake/DermisModule.cmake), where the first that asks for a size puts it.
inline scene::AssetData kept_built_in_head(int map_size) {
  return builtin_head::make({.map_size = map_size, .cache = cache::default_folder()});
}

/// The same with the smallest maps, once per program; its mesh does not depend on their size.
inline const scene::AssetData& built_in_head() {
  static const scene::AssetData head = kept_built_in_head(64);
  return head;
}

}  // namespace dermis::tests
