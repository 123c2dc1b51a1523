// SPDX-License-Identifier: MIT
/// Saves documents as files that the command line takes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viewer/model/document.h"

namespace dermis::viewer {

/// Where the files of one name lie: "portrait" gives portrait.png, portrait.exr, portrait.settings.json,
/// portrait.scene.json, portrait.profile.json.
struct SaveNames {
  std::filesystem::path picture, light, settings, scene, profile;
};
/// `name`: with or without a folder; an ending of a picture is left out. Throws InputError: it is empty.
SaveNames save_names(const std::string& name);

/// The scene that was written last, and where.
struct SavedScene {
  Scene scene;
  std::filesystem::path file;
};

/// Returns the words that name the scene of the document on a command line: those that opened it, if nothing
/// was changed since, else the scene file. None: it is in no file yet.
std::optional<std::vector<std::string>> scene_words(const Document& document,
                                                    const std::optional<SavedScene>& saved);

/// Writes the settings with how the scene was read, as --settings takes them.
void save_settings(const Document& document, const std::filesystem::path& file);

/// Returns the profile that the first skin of the document has.
ScatterProfile profile_of(const Document& document);

}  // namespace dermis::viewer
