// SPDX-License-Identifier: MIT
#include "support/assets.h"

#include <fmt/format.h>

#include <cstdlib>

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

// DERMIS_SOURCE is set where tests run away from the tree that they were built from: apps/kit.
fs::path source() {
  const char* folder = std::getenv("DERMIS_SOURCE");
  return folder != nullptr ? folder : DERMIS_SOURCE_DIR;
}

fs::path scan_folder() { return source() / "assets" / "heads"; }

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

}  // namespace

fs::path asset_cache() {
  if (const char* folder = std::getenv("DERMIS_ASSET_CACHE")) return folder;
  return source() / ".." / "shared" / "assets";
}

fs::path scan_manifest(const std::string& name) { return scan_folder() / name; }

std::string missing_asset(const std::vector<fs::path>& files) {
  for (const fs::path& file : files)
    if (!is_there(file))
      return fmt::format("{} is not there; set DERMIS_ASSET_CACHE to the folder of the shared assets",
                         file.string());
  return "";
}

std::string missing_scan(const std::vector<std::string>& maps) {
  std::vector<std::string> files{"LeePerrySmith.glb", "Map-COL.jpg"};
  files.insert(files.end(), maps.begin(), maps.end());

  for (const std::string& file : files)
    if (!is_there(scan_folder() / file))
      return fmt::format("the scan's {} is not there; ./run fetch-assets brings it", file);
  return "";
}

}  // namespace dermis::tests
