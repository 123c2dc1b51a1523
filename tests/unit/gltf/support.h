// SPDX-License-Identifier: MIT
// What the loader's tests share: glTF files built in memory, errors and warnings.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "dermis/error.h"
#include "head/scene/gltf/load.h"
#include "support/assets.h"
#include "support/files.h"
#include "support/log_lines.h"

namespace dermis::scene::test {

using Json = nlohmann::json;
namespace fs = std::filesystem;
using tests::asset_cache;
using tests::missing_asset;
using tests::read_text;
using tests::TempFolder;
using tests::write_text;

/// The shared assets ($DERMIS_ASSET_CACHE, else beside the source); none if they are not there.
std::optional<fs::path> assets();

/// The smallest PNG: one pixel, red and half transparent, as a data uri.
inline constexpr const char* one_pixel =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==";

/// A document and its one buffer. Starts as an empty scene; `json` may be bent in any way before it is
/// loaded.
class Builder {
 public:
  Builder();
  /// Appends the numbers as a bufferView and an accessor; returns the accessor's index. Integers are given as
  /// floats too.
  int accessor(const std::vector<float>& values, const std::string& type, int component = 5126);
  /// A mesh with one primitive of the given attributes, and a node in the scene that holds it; returns the
  /// mesh's index.
  int mesh(const Json& attributes, int indices = -1);
  /// Triangle (0,0,0) (0.2,0,0) (0,0.2,0) with coordinates (0,0) (1,0) (0,1); returns the mesh's index.
  int triangle();

  std::string glb() const;
  fs::path write(const fs::path& folder, const std::string& name = "built.glb") const;
  AssetData load(const LoadOptions& options = {}) const;
  /// The one-line error of loading, "" if it loads.
  std::string error(const LoadOptions& options = {}) const;

  Json json;
  std::string bytes;
};

/// "" if it loads.
std::string error_of(const fs::path& path, const LoadOptions& options = {});

/// Collects warnings while it lives, so that they are checked instead of printed.
class Warnings {
 public:
  bool any_with(const std::string& part) const;
  std::string all() const;

 private:
  tests::LogLines said_;
};

/// Fails where `actual` is more than `tolerance` away from `expected`.
inline void expect_near(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 1e-5f) {
  EXPECT_NEAR(glm::distance(actual, expected), 0, tolerance)
      << actual.x << " " << actual.y << " " << actual.z;
}

}  // namespace dermis::scene::test

#define DERMIS_NEED_ASSETS(variable)                     \
  const auto variable = ::dermis::scene::test::assets(); \
  if (!variable) GTEST_SKIP() << "the shared assets are not in DERMIS_ASSET_CACHE"

/// The error must hold this text.
#define EXPECT_ERROR(error, part) \
  EXPECT_NE((error).find(part), std::string::npos) << "error: '" << (error) << "'"
