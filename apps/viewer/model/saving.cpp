// SPDX-License-Identifier: MIT
#include "viewer/model/saving.h"

#include "api/asset_state.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "base/settings/json.h"
#include "tissue/gaussians/known.h"
#include "tissue/gaussians/scatter_profile.h"
#include "viewer/model/command_line.h"

namespace dermis::viewer {

SaveNames save_names(const std::string& name) {
  std::filesystem::path base(name);
  if (base.filename().empty()) throw InputError("save", "the files need a name");
  if (ending_of(base) == ".png" || ending_of(base) == ".exr") base.replace_extension();
  const auto with = [&](const char* ending) { return std::filesystem::path(base.string() + ending); };
  return {.picture = with(".png"),
          .light = with(".exr"),
          .settings = with(".settings.json"),
          .scene = with(".scene.json"),
          .profile = with(".profile.json")};
}

std::optional<std::vector<std::string>> scene_words(const Document& document,
                                                    const std::optional<SavedScene>& saved) {
  const Opened& opened = *document.opened;
  if (same_contents(opened.scene, document.scene)) {
    std::vector<std::string> words = opened.words;
    const std::vector<std::string> options = option_words(opened.options);
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }
  if (saved && same_contents(saved->scene, document.scene)) return {{saved->file.string()}};
  return {};
}

void save_settings(const Document& document, const std::filesystem::path& file) {
  write_file(file,
             to_json({.render = document.settings, .scene = document.opened->options, .reference = {}}));
}

ScatterProfile profile_of(const Document& document) {
  const SkinSettings& skin = document.settings.skin;
  if (!skin.profile.empty()) return load_profile(skin.profile);

  const std::vector<InstanceId> ids = document.scene.instances();
  for (const InstanceId id : ids)
    if (const auto& profile = document.scene.instance(id).profile) return *profile;
  for (const InstanceId id : ids)
    for (const scene::Material& material : Asset::State::of(document.scene.instance(id).asset)->materials)
      if (material.skin && material.skin_settings.profile) return *material.skin_settings.profile;
  return load_profile("skin");
}

}  // namespace dermis::viewer
