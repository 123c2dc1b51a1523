// SPDX-License-Identifier: MIT
#include "tools/dataset/inputs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <utility>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/json/document.h"
#include "head/scene/gltf/document.h"
#include "head/scene/gltf/uri.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;
namespace gltf = scene::gltf;

constexpr std::size_t most_trees = 20'000;
// As people write licences, and SPDX's identifiers.
constexpr std::array<std::pair<std::string_view, const char*>, 10> spellings{
    {{"CC BY-SA 4.0", "CC-BY-SA-4.0"},
     {"CC BY 4.0", "CC-BY-4.0"},
     {"CC-BY-4.0", "CC-BY-4.0"},
     {"CC BY 3.0", "CC-BY-3.0"},
     {"CC-BY-3.0", "CC-BY-3.0"},
     {"CC0", "CC0-1.0"},
     {"Apache-2.0", "Apache-2.0"},
     {"Apache License 2.0", "Apache-2.0"},
     {"MIT License", "MIT"},
     {"MIT", "MIT"}}};

// "MIT" is no word of "SMITH".
bool has_word(std::string_view text, std::string_view word) {
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '-');
  };
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1))
    if (!is_letter(at - 1) && !is_letter(at + word.size())) return true;
  return false;
}

bool is_built_in(const std::string& asset) { return asset == "built-in" || asset.starts_with("built-in:"); }

// The file of an asset and what lies beside it.
std::set<std::string> files_of_asset(const std::string& file) {
  std::set<std::string> files{file};
  const gltf::Container container = gltf::open_container(file);
  const json::Document json = gltf::parse(container.json, file);
  const gltf::Document document = gltf::read_document(json.root(), container, file);
  const auto add = [&](const std::optional<std::string>& uri) {
    if (uri && !uri->starts_with("data:"))
      files.insert(gltf::uri_path(fs::path(file).parent_path(), *uri, file));
  };
  for (const gltf::Buffer& buffer : document.buffers) add(buffer.uri);
  // Only materials that are used need their pictures.
  for (const gltf::ImageSource& image : document.images) try {
      add(image.uri);
    } catch (const InputError&) { continue; }
  return files;
}

void add_settings_files(const Recipe::State& recipe, std::set<std::string>& files) {
  for (const Json& tree : extremes(recipe.settings, "settings", most_trees)) {
    const RenderSettings settings = settings_of(recipe, tree);
    const std::string& environment = settings.lighting.environment;
    if (!environment.empty() && environment != "studio") files.insert(environment);
    std::error_code ignored;
    if (fs::is_regular_file(settings.skin.profile, ignored)) files.insert(settings.skin.profile);
  }
}

void add_option_files(const Recipe::State& recipe, const Entry& entry, std::set<std::string>& files) {
  for (const Json& tree : extremes(entry.options, "options", most_trees)) {
    const SceneOptions options = options_of(recipe, tree);
    for (const std::string& map : {options.melanin_map, options.haemoglobin_map})
      if (!map.empty()) files.insert(map);
  }
}

std::string name_of(const Recipe::State& recipe, const std::string& file) {
  const fs::path relative = fs::path(file).lexically_relative(recipe.folder.empty() ? "." : recipe.folder);
  return relative.empty() ? file : relative.generic_string();
}

}  // namespace

std::vector<Input> inputs_of(const Recipe::State& recipe) {
  std::set<std::string> files, optional;
  add_settings_files(recipe, files);
  for (const Entry& entry : recipe.entries) {
    add_option_files(recipe, entry, files);
    if (is_built_in(entry.asset)) continue;
    const std::string file = recipe.file(entry.asset);
    files.insert(file);
    optional.merge(files_of_asset(file));
  }

  std::error_code ignored;
  for (const std::string& file : optional)
    if (fs::is_regular_file(file, ignored)) files.insert(file);
  std::vector<Input> inputs;
  for (const std::string& file : files) inputs.push_back({name_of(recipe, file), hash_of_file(file)});
  std::ranges::sort(inputs, {}, &Input::file);
  return inputs;
}

std::optional<Licence> licence_in(const fs::path& asset) {
  const gltf::Container container = gltf::open_container(asset);
  const json::Document json = gltf::parse(container.json, asset.string());
  const auto header = json.root().find("asset");
  const std::string text = header && header->is_object() ? header->text_or("copyright", "") : "";
  if (text.empty()) return std::nullopt;

  Licence licence{"LicenseRef-asset.copyright", text, asset.filename().string(), ""};
  for (const auto& [spelling, spdx] : spellings)
    if (has_word(text, spelling)) {
      licence.spdx = spdx;
      break;
    }
  return licence;
}

void find_licences(Recipe::State& recipe) {
  for (std::size_t i = 0; i < recipe.entries.size(); ++i) {
    Entry& entry = recipe.entries[i];
    if (!entry.licence.spdx.empty()) continue;
    if (const auto found = licence_in(recipe.file(entry.asset))) entry.licence = *found;
    if (entry.licence.spdx.empty())
      throw input_error(
          "recipe",
          "identities[{}]: {} has no licence: its asset.copyright is empty, and the recipe says "
          "none; add \"licence\": {{\"spdx\", \"author\", \"source\", \"changes\"}}",
          i, entry.asset);
  }
}

}  // namespace dermis::dataset
