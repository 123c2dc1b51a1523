// SPDX-License-Identifier: MIT
// Every glTF file of the corpus that draws: no pixel of its skin reads a texel that was never lit.
// DERMIS_CORPUS names another folder to look in: that of all shared assets, or of files of one's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "base/core/error.h"
#include "gpu/support/renderer.h"
#include "gpu/unwraps/made_up.h"
#include "support/assets.h"
#include "support/log_lines.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders() {
  if (const char* folder = std::getenv("DERMIS_CORPUS")) return {folder};
  return {asset_cache() / "gltf-valid", asset_cache() / "gltf-malformed"};
}

std::vector<fs::path> files() {
  std::vector<fs::path> found;
  for (const fs::path& folder : folders()) {
    if (!fs::exists(folder)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
        found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Reads of texels without light, over three views; none if the file cannot be drawn.
std::optional<std::uint64_t> unshaded_reads(const fs::path& file) {
  try {
    RenderSettings s = tiny_settings(32, 64);
    s.lighting.rig_lights = 1;
    PreparedFrame frame = renderer().prepare(Scene::load(file), s);
    std::uint64_t reads = 0;
    for (const auto& orbit_deg : {std::array{0.001, 0.0}, {100.0, 30.0}, {215.0, -30.0}}) {
      s.camera.orbit_deg = orbit_deg;
      frame.set(s);
      reads += frame.picture().statistics.unshaded_reads;
    }
    return reads;
  } catch (const InputError&) { return std::nullopt; }
}

TEST(Corpus, EachReadFindsLight) {
  LogLines quiet;
  int drawn = 0;
  for (const fs::path& file : files()) {
    const std::optional<std::uint64_t> reads = unshaded_reads(file);
    if (!reads) continue;
    ++drawn;
    EXPECT_EQ(*reads, 0u) << file;
  }
  if (drawn == 0) GTEST_SKIP() << "set DERMIS_ASSET_CACHE to the folder of the shared assets";
  std::cout << drawn << " files drawn\n";
}

}  // namespace
}  // namespace dermis::tests
