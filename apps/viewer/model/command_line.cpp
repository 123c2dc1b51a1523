// SPDX-License-Identifier: MIT
#include "viewer/model/command_line.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <type_traits>

#include "base/settings/fields.h"
#include "cli/command_line.h"
#include "dermis/setting_rows.h"

namespace dermis::viewer {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& value) {
  if (value.is_string()) return value;
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  if (!value.is_structured()) return value.dump();
  std::string text;
  for (const Json& one : value) text += (text.empty() ? "" : ",") + text_of(one);
  return text;
}

// The values of one setting, as its option takes them. Only one whose default is a number has a word for
// none.
std::vector<std::string> values_of(const SettingRow& row) {
  const Json value = Json::parse(row.initial);
  if (value.is_null()) return {row.none};
  if (value.is_boolean()) return {value ? row.on : row.off};
  const bool several = row.kind == SettingRow::Kind::lights || row.kind == SettingRow::Kind::texts;
  if (!several || !value.is_array()) return {text_of(value)};
  std::vector<std::string> values;
  for (const Json& one : value) values.push_back(text_of(one));
  return values;
}

// The switches that a list names.
void add_optimise(const QualitySettings& quality, std::vector<std::string>& words) {
  std::string names, option;
  bool all = true;
  for_each_setting(quality,
                   [&](const std::string& name, const About& about, const auto& value, std::string_view) {
                     if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, bool>)
                       if (about.option == "optimise") {
                         option = "--" + std::string(about.option);
                         all = all && value;
                         if (value) names += (names.empty() ? "" : ",") + name;
                       }
                   });
  if (all) return;
  words.push_back(option);
  words.push_back(names.empty() ? "none" : names);
}

// `parent`: place of the structure in a file of settings. Without size and switches, which share options, and
// frames, of which a picture is one.
template <class Settings>
std::vector<std::string> words_of(const Settings& settings, std::string_view parent) {
  std::vector<std::string> words;
  const std::vector<SettingRow> rows = rows_of(settings), defaults = rows_of(Settings{});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SettingRow& row = rows[i];
    if (row.initial == defaults[i].initial || row.option == "size" || row.option == "optimise" ||
        row.option == "frames")
      continue;
    if (row.option.empty())
      words.insert(words.end(), {"--set", path_of(parent, row.path) + "=" + row.initial});
    else
      for (const std::string& value : values_of(row)) words.insert(words.end(), {"--" + row.option, value});
  }
  return words;
}

}  // namespace

std::vector<std::string> option_words(const RenderSettings& settings) {
  std::vector<std::string> words = words_of(settings, "");
  add_optimise(settings.quality, words);
  const OutputSettings size;
  if (settings.output.width != size.width || settings.output.height != size.height) {
    words.emplace_back("--size");
    words.push_back(fmt::format("{}x{}", settings.output.width, settings.output.height));
  }
  return words;
}

std::vector<std::string> option_words(const SceneOptions& options) { return words_of(options, "scene"); }

std::string render_command(const std::vector<std::string>& scene_words, const RenderSettings& settings,
                           std::string_view device, std::string_view output) {
  std::string line = "dermis render";
  for (const std::string& word : scene_words)
    line += " " + cli::quoted(word.starts_with("-") ? "./" + word : word);
  for (const std::string& word : option_words(settings)) line += " " + cli::quoted(word);
  if (device != "best") line += " --device " + cli::quoted(device);
  return line + " -o " + cli::quoted(output);
}

}  // namespace dermis::viewer
