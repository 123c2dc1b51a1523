// SPDX-License-Identifier: MIT
// The public scan as bare geometry, read without the glTF loader so that geometry is tested on its own.
#pragma once

#include <optional>

#include "head/scene/asset_data.h"

namespace dermis::scene::test {

/// One skin primitive in metres (1 unit of the file = 0.053 m), coordinates as in the file (v up), tangents
/// made for v down. None where the asset cache lacks it.
std::optional<AssetData> load_scan();

Material material(const std::string& name, bool skin);

}  // namespace dermis::scene::test

#define DERMIS_NEED_SCAN(variable)                          \
  const auto variable = ::dermis::scene::test::load_scan(); \
  if (!variable) GTEST_SKIP() << "the scan is not in DERMIS_ASSET_CACHE (run: ./run fetch-assets)"
