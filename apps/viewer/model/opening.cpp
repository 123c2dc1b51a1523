// SPDX-License-Identifier: MIT
#include "viewer/model/opening.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hooks.h"
#include "base/settings/json.h"
#include "environment/environment.h"

namespace dermis::viewer {
namespace {

// The camera of one scene says nothing of another.
void show_scene(Document& document, const std::shared_ptr<const Opened>& opened) {
  document.opened = opened;
  document.scene = opened->scene;
  document.skin = {};
  CameraSettings camera;
  camera.heads = opened->scene.instances().size() == 1 ? document.settings.camera.heads : 1;
  document.settings.camera = camera;
}

OpenedFile read_scene(const std::filesystem::path& path, const SceneOptions& options, const Hooks& hooks) {
  auto opened = std::make_shared<Opened>();
  opened->words = {path.string()};
  opened->options = options;
  opened->scene = Scene::load(path, options, hooks);
  return {.what = "open " + path.filename().string(),
          .into = [opened](Document& document) { show_scene(document, opened); }};
}

OpenedFile read_environment(const std::filesystem::path& path) {
  environment::load(path);  // throws what is wrong with it, before anything is changed
  return {.what = "surroundings " + path.filename().string(),
          .into = [path](Document& document) { document.settings.lighting.environment = path.string(); }};
}

OpenedFile read_profile(const std::filesystem::path& path) {
  const ScatterProfile profile = load_profile(path.string());
  return {.what = "profile " + path.filename().string(), .into = [profile](Document& document) {
            document.skin.kind = SkinKind::gaussians;
            document.skin.gaussians = profile;
            set_profile(document, profile);
          }};
}

OpenedFile read_settings(const Document& document, const std::filesystem::path& path, const Hooks& hooks) {
  SettingsFile file{.render = document.settings, .scene = document.opened->options, .reference = {}};
  load_settings(path, file);
  const std::string what = "settings " + path.filename().string();
  const auto take = [render = file.render](Document& changed) { changed.settings = render; };

  // Options of reading need the files read again, of a scene that is still the one of the file.
  const Opened& opened = *document.opened;
  const bool is_as_opened = opened.words.size() == 1 && same_contents(opened.scene, document.scene);
  if (to_json({.render = {}, .scene = file.scene, .reference = {}}) ==
          to_json({.render = {}, .scene = opened.options, .reference = {}}) ||
      !is_as_opened)
    return {.what = what, .into = take};
  const OpenedFile again = read_scene(opened.words.front(), file.scene, hooks);
  return {.what = what, .into = [take, again](Document& changed) {
            again.into(changed);
            take(changed);
          }};
}

}  // namespace

OpenedFile read_file_for(const Document& document, const std::filesystem::path& path, const Hooks& hooks) {
  const HookScope scope(hooks);
  const std::string ending = ending_of(path);
  if (ending == ".glb" || ending == ".gltf") return read_scene(path, document.opened->options, hooks);
  if (ending == ".hdr" || ending == ".exr") return read_environment(path);
  if (ending != ".json")
    throw input_error(path.string(),
                      "is none of .glb, .gltf, .hdr, .exr and .json (a scene file, a profile or settings)");

  const std::vector<std::byte> bytes = read_file(path, 64u << 20);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.find("\"dermis_scene\"") != std::string_view::npos)
    return read_scene(path, document.opened->options, hooks);
  if (text.find("\"variances_mm2\"") != std::string_view::npos) return read_profile(path);
  return read_settings(document, path, hooks);
}

void set_profile(Document& document, const ScatterProfile& profile) {
  document.settings.skin.profile.clear();
  for (const InstanceId id : document.scene.instances()) document.scene.set_profile(id, profile);
}

void clear_profile(Document& document) {
  for (const InstanceId id : document.scene.instances()) document.scene.set_profile(id, {});
}

}  // namespace dermis::viewer
