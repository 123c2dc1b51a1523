// SPDX-License-Identifier: MIT
#include "cli/settings_options.h"

#include <fmt/format.h>

#include "base/settings/comparison_fields.h"
#include "base/settings/fields.h"
#include "base/settings/profile_fields.h"
#include "cli/help.h"

namespace dermis::cli {
namespace {

// Where an option of one command is not called as in the others.
struct OtherName {
  std::string_view path, option;
};
constexpr OtherName other_names[] = {{"quality.samples", "msaa"}, {"camera.distance", "distances"}};

std::string option_of(const std::string& path, const About& about, const CLI::App& command) {
  const auto has = [&](std::string_view name) {
    return command.get_option_no_throw("--" + std::string(name)) != nullptr;
  };
  for (const OtherName& other : other_names)
    if (path == other.path && has(other.option)) return "--" + std::string(other.option);
  return !about.option.empty() && has(about.option) ? "--" + std::string(about.option) : "";
}

bool is_part_of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '/' || c == '\\';
}

void insert_after(std::string& message, const std::string& path, const std::string& text) {
  std::size_t end = 0;
  for (std::size_t at = message.find(path); at != std::string::npos; at = message.find(path, end)) {
    end = at + path.size();
    if (at > 0 && (is_part_of_word(message[at - 1]) || message[at - 1] == '.')) continue;
    if (end < message.size() && is_part_of_word(message[end])) continue;

    // "lighting.placed_lights[0].irradiance": after the whole.
    if (end < message.size() && message[end] == '[') end = std::min(message.find(' ', end), message.size());
    message.insert(end, text);
    end += text.size();
  }
}

}  // namespace

std::string help_of(const About& about) {
  std::string help(about.help);
  if (!about.unit.empty() && help.find(about.unit) == std::string::npos)
    help += fmt::format(", {}", about.unit);
  if (!about.none.empty() && about.none.find(' ') != std::string_view::npos)
    help += fmt::format(" (default: {})", about.none);
  return help;
}

std::string help_with_range(const About& about) {
  const std::string range = range_text(about);
  return std::string(about.help) + (range.empty() ? "" : ", " + range);
}

std::string with_options(std::string message, const CLI::App& app) {
  const std::vector<const CLI::App*> commands =
      app.get_subcommands([](const CLI::App* c) { return c->parsed(); });
  if (commands.empty()) return message;

  // A message that begins with an option needs no other.
  if (message.starts_with("--")) return message;

  const CLI::App& command = *commands.front();
  const auto one = [&](const std::string& path, const About& about, const auto&, std::string_view) {
    const std::string option = option_of(path, about, command);
    // A setting of one word, like "technique", may be any word of a message: only where a sentence is about
    // it.
    const bool is_word = path.find_first_of("._") == std::string::npos;
    if (option.empty() ||
        (is_word && !message.starts_with(path + ":") && !message.starts_with(path + " must be")))
      return;
    insert_after(message, path, " (" + option + ")");
  };
  const RenderSettings render;
  const SceneOptions scene;
  const ReferenceSettings reference;
  const SceneComparisonSettings comparison;
  const ProfileOptions profile;
  const SpectralSkin skin;
  for_each_setting(render, one);
  for_each_setting(scene, one);
  for_each_setting(reference, one);
  for_each_setting(comparison, one);
  for_each_setting(profile, one);
  for_each_setting(skin, one);
  return message;
}

CLI::Option* file_under(const std::string& title, const About& about, CLI::Option* option) {
  option->group(title);
  return about.common ? option : rare(option);
}

CLI::Option* AddOption::operator()(const std::string& name, const About& about,
                                   std::array<double, 2>& value) const {
  return command
      .add_option_function<std::vector<double>>(
          name,
          [&value](const std::vector<double>& angles) {
            value = {angles[0], angles[1]};
          },
          help_of(about))
      ->delimiter(',')
      ->expected(2)
      ->type_name("AZ,EL")
      ->default_str(fmt::format("{:g},{:g}", value[0], value[1]));
}

CLI::Option* AddOption::operator()(const std::string& name, const About& about,
                                   std::optional<std::array<double, 3>>& value) const {
  const auto read = [&value](const std::vector<double>& point) { value = {point[0], point[1], point[2]}; };
  return command.add_option_function<std::vector<double>>(name, read, help_of(about))
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,Z");
}

CLI::Option* AddOption::with_values(const About& about, CLI::Option* option) {
  return about.values.empty() ? option : option->type_name(std::string(about.values));
}

CLI::Option* AddOption::add_number_or(const std::string& name, const About& about,
                                      std::optional<double>& value) const {
  const std::string word(about.none), type = fmt::format("{}|{}", about.unit, word);
  const auto read = [&value, word, name, type](const std::string& text) {
    value.reset();
    if (text == word) return;
    const char* const end = text.data() + text.size();
    const auto number = std::from_chars(text.data(), end, value.emplace());
    if (number.ec != std::errc() || number.ptr != end)
      throw CLI::ValidationError(
          name, fmt::format("expected {} or {}, got '{}'", type.substr(0, type.find('|')), word, text));
  };
  return command.add_option_function<std::string>(name, read, help_of(about))
      ->type_name(type)
      ->default_str(value ? fmt::format("{:g}", *value) : word);
}

}  // namespace dermis::cli
