// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "api/asset_options.h"
#include "api/asset_state.h"
#include "api/prepare/scene_file.h"
#include "base/core/cache.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hooks.h"
#include "base/core/known_names.h"
#include "dermis/scene.h"
#include "head/builtin_head/builtin_head.h"
#include "head/scene/gltf/load.h"

namespace dermis {
namespace {

// "built-in:NAME" is no file.
constexpr std::string_view built_in_prefix = "built-in:";

builtin_head::Tone tone_of(const std::string& name, std::string_view skin) {
  constexpr auto& names = builtin_head::tone_names;
  const auto found = std::ranges::find(names, skin);
  if (found == names.end())
    throw input_error(name, "the built-in head has no skin '{}'; {}", skin, listed_names(skin, names));
  return static_cast<builtin_head::Tone>(found - names.begin());
}

}  // namespace

Asset Asset::load(const std::filesystem::path& path, const SceneOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  const scene::LoadOptions load = api::load_options(options);
  if (const std::string name = path.string(); name.starts_with(built_in_prefix)) {
    const std::string skin = name.substr(built_in_prefix.size());
    scene::AssetData made =
        builtin_head::make({.tone = tone_of(name, skin), .cache = cache::default_folder()});
    if (skin != "medium") made.name = name;
    const bool changed = api::changes_pigments(options);
    return State::make(
        api::finished(std::move(made), options),
        changed ? std::nullopt : std::optional(State::Source{.file = {}, .options = {}, .skin = skin}));
  }
  if (api::open_scene_file(path))
    throw input_error(path.string(), "is a scene file, and an asset is glTF; give a scene file alone");

  return State::make(api::finished(scene::load_gltf(path, load), options),
                     State::Source{.file = std::filesystem::absolute(path), .options = options});
}

Asset Asset::built_in(const Hooks& hooks) {
  const HookScope scope(hooks);
  scene::AssetData made = builtin_head::make({.cache = cache::default_folder()});
  return State::make(api::finished(std::move(made)), State::Source{});
}

Scene Scene::load(const std::filesystem::path& path, const SceneOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  const bool is_built_in = path.string().starts_with(built_in_prefix);
  if (const auto file = is_built_in ? std::nullopt : api::open_scene_file(path))
    return api::load_scene_file(file->root(), path, options);
  return Scene(Asset::load(path, options));
}

void Scene::save(const std::filesystem::path& path) const {
  write_file(path, api::scene_file_text(*this, path));
}

Scene Scene::built_in(const Hooks& hooks) { return Scene(Asset::built_in(hooks)); }

}  // namespace dermis
