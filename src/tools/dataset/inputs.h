// SPDX-License-Identifier: MIT
// The files that a recipe names, and the licences of its assets.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/dataset/recipe.h"
#include "tools/dataset/sha256.h"

namespace dermis::dataset {

struct Input {
  std::string file;  ///< as the recipe names it, or relative to its folder
  FileHash hash;
  bool operator==(const Input&) const = default;
};

/// Returns all files that any sample may read, sorted, each once: assets with their buffers and pictures,
/// surroundings, profiles, maps of pigments. Throws InputError: one is not there.
std::vector<Input> inputs_of(const Recipe::State& recipe);

/// Returns what the file of an asset says of its own licence (asset.copyright); none if it says nothing.
std::optional<Licence> licence_in(const std::filesystem::path& asset);

/// Fills in licences that the recipe leaves to the files. Throws InputError: an asset has none.
void find_licences(Recipe::State& recipe);

}  // namespace dermis::dataset
