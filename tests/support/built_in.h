// SPDX-License-Identifier: MIT
#pragma once
#include "builtin_head/builtin_head.h"
#include "core/cache.h"

namespace dermis::tests {

/// Returns the built-in head with its smallest maps; its mesh does not depend on their size. Made once by all
/// tests of a build, which share a folder of kept files (cmake/DermisModule.cmake).
inline const scene::Scene& built_in_head() {
  static const scene::Scene head = builtin_head::make({.map_size = 64, .cache = cache::default_folder()});
  return head;
}

}  // namespace dermis::tests
