// SPDX-License-Identifier: MIT
// Files that tests use where they are at hand. What a test needs and does not find, it says in its skip.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dermis::tests {

/// The folder of heads, surroundings and corpora: $DERMIS_ASSET_CACHE, else shared/assets beside the
/// checkout. It may not be there.
std::filesystem::path asset_cache();

/// A manifest of the scan in assets/heads.
std::filesystem::path scan_manifest(const std::string& name = "lee-perry-smith.gltf");

/// Says which of the files is not there and what to do; empty if all are.
std::string missing_asset(const std::vector<std::filesystem::path>& files);

/// The same for what the scan is made of: `maps` beside its mesh and its colours.
std::string missing_scan(const std::vector<std::string>& maps = {});

}  // namespace dermis::tests
