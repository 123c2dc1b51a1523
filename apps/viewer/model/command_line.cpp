// SPDX-License-Identifier: MIT
#include "viewer/model/command_line.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <type_traits>

#include "cli/command_line.h"
#include "settings/fields.h"
#include "settings/names.h"

namespace dermis::viewer {
namespace {

template <class Value>
std::string text_of(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return std::string(name_of(value));
  else
    return fmt::format("{}", value);
}

std::string text_of(const std::array<double, 2>& value) { return fmt::format("{},{}", value[0], value[1]); }
std::string text_of(const std::array<double, 3>& value) {
  return fmt::format("{},{},{}", value[0], value[1], value[2]);
}

// The words of one setting that differs from its default.
struct Words {
  std::vector<std::string>& words;

  void add(const About& about, std::string value) const {
    words.push_back("--" + std::string(about.option));
    words.push_back(std::move(value));
  }

  template <class Value>
  void operator()(const About& about, const Value& value) const {
    add(about, text_of(value));
  }

  void operator()(const About& about, const bool& value) const {
    if (about.on.empty())
      words.push_back("--" + std::string(about.option));
    else
      add(about, std::string(value ? about.on : about.off));
  }

  template <class Value>
  void operator()(const About& about, const std::optional<Value>& value) const {
    // Only a setting whose default is a number has a word for none.
    add(about, value ? text_of(*value) : std::string(about.none));
  }

  void operator()(const About& about, const std::vector<std::string>& values) const {
    for (const std::string& value : values) add(about, value);
  }

  void operator()(const About& about, const std::vector<PlacedLight>& lights) const {
    for (const PlacedLight& light : lights)
      add(about, fmt::format("{},{},{}", light.azimuth_deg, light.elevation_deg, light.irradiance));
  }
};

template <class Value>
bool equal(const Value& a, const Value& b) {
  return a == b;
}

bool equal(const std::vector<PlacedLight>& a, const std::vector<PlacedLight>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].azimuth_deg != b[i].azimuth_deg || a[i].elevation_deg != b[i].elevation_deg ||
        a[i].irradiance != b[i].irradiance)
      return false;
  return true;
}

// Visits the rows of two structures together: visit(path, about, value, default value).
template <class Settings, class Visit>
void for_each_pair(const Settings& settings, const Settings& defaults, const Visit& visit) {
  const auto one = [&](const auto& field) {
    const auto& value = settings.*field.member;
    const auto& of_default = defaults.*field.member;
    if constexpr (has_fields<std::remove_cvref_t<decltype(value)>>)
      for_each_pair(value, of_default, visit);
    else
      visit(field.about, value, of_default);
  };
  std::apply([&](const auto&... field) { (one(field), ...); }, fields_of<Settings>);
}

// Settings that share an option: switches that a list names, and the size.
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

template <class Settings>
std::vector<std::string> words_of(const Settings& settings) {
  std::vector<std::string> words;
  for_each_pair(settings, Settings{}, [&](const About& about, const auto& value, const auto& of_default) {
    if (about.option.empty() || about.option == "size" || about.option == "optimise") return;
    if (!equal(value, of_default)) Words{words}(about, value);
  });
  return words;
}

}  // namespace

std::vector<std::string> option_words(const RenderSettings& settings) {
  RenderSettings one_frame = settings;
  one_frame.output.frames = OutputSettings{}.frames;
  std::vector<std::string> words = words_of(one_frame);
  add_optimise(settings.quality, words);
  const OutputSettings size;
  if (settings.output.width != size.width || settings.output.height != size.height) {
    words.emplace_back("--size");
    words.push_back(fmt::format("{}x{}", settings.output.width, settings.output.height));
  }
  return words;
}

std::vector<std::string> option_words(const SceneOptions& options) { return words_of(options); }

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
