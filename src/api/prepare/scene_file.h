// SPDX-License-Identifier: MIT
/// Scene files: a scene as JSON, whose assets stay in files of their own. docs/scenes.md says what one holds.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "api/asset_state.h"
#include "base/json/document.h"
#include "dermis/scene.h"

namespace dermis::api {

inline constexpr int scene_file_version = 1;
/// The member at the top by which a scene file is known; its value is the version.
inline constexpr const char* scene_file_key = "dermis_scene";
inline constexpr json::Limits scene_file_limits{.depth = 8, .values = 4'000'000};

/// A scene file that has been read and checked, before its assets are loaded, which takes seconds.
struct SceneFile {
  std::vector<Asset::State::Source> assets;
  Scene scene;  ///< whole, but its instances share an asset that is empty
  std::vector<std::size_t> asset_of_instance;
  std::vector<std::optional<RigPose>> pose_of_instance;  ///< taken once its asset is there
};

/// Returns the JSON of a scene file; none for any other file, known by its content. Throws InputError: what
/// could be one is not valid JSON, or beyond the limits.
std::optional<json::Document> open_scene_file(const std::filesystem::path& path);

/// Reads the JSON; `path` is that of its file. `options`: what its assets do not say themselves. Reads files
/// of profiles and no others. Throws InputError with the place.
SceneFile read_scene_file(const json::Value& root, const std::filesystem::path& path,
                          const SceneOptions& options);

/// Reads a scene file and loads the assets that its instances name.
Scene load_scene_file(const json::Value& root, const std::filesystem::path& path,
                      const SceneOptions& options);

/// Returns the text of a scene file at this path. Throws InputError as Scene::save().
std::string scene_file_text(const Scene& scene, const std::filesystem::path& path);

}  // namespace dermis::api
