// SPDX-License-Identifier: MIT
#include "cli/command_line.h"

#include <charconv>
#include <string_view>
#include <system_error>

#include "base/settings/fields.h"

namespace dermis::cli {
namespace {

// One number, or several with commas between them.
bool is_numbers(std::string_view text) {
  while (true) {
    const std::string_view first = text.substr(0, text.find(','));
    double number = 0;
    const auto [at, error] = std::from_chars(first.data(), first.data() + first.size(), number);
    if (error != std::errc() || at != first.data() + first.size()) return false;

    if (first.size() == text.size()) return true;
    text.remove_prefix(first.size() + 1);
  }
}

bool is_optimisation(std::string_view text) {
  bool found = text == "all" || text == "none";
  const QualitySettings quality;
  for_each_setting(quality, [&](const std::string& name, const About& about, const auto&, std::string_view) {
    found = found || (about.option == "optimise" && text == name);
  });
  return found;
}

// Whether `text` can be one more value of the list that `option` has begun.
bool belongs_to(std::string_view option, std::string_view text) {
  if (option == "--heads" || option == "--distances") return is_numbers(text);
  // Where techniques are compared no other words may stand, and a name that is not known is to be told so.
  if (option == "--techniques") return !text.empty() && !text.starts_with('-');
  return option == "--optimise" && is_optimisation(text);
}

}  // namespace

std::vector<std::string> join_lists(const std::vector<std::string>& arguments) {
  std::vector<std::string> joined;
  std::string_view list;  // the option whose values are being read
  bool has_value = false;

  for (const std::string& argument : arguments) {
    if (has_value && belongs_to(list, argument)) {
      joined.back() += "," + argument;
      continue;
    }
    joined.push_back(argument);

    if (argument.starts_with("--")) {
      list = std::string_view(argument).substr(0, argument.find('='));
      has_value = list.size() < argument.size();
    } else {
      // The first word after the option is its value; a further one that is none ends the list.
      if (has_value) list = {};
      has_value = !has_value && !list.empty();
    }
  }
  return joined;
}

CLI::Option* add_count(CLI::App& command, const std::string& name, std::uint64_t& value,
                       const std::string& help, const std::string& range) {
  const auto read = [&value, name, range](const std::string& text) {
    const char* const end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || at != end)
      throw CLI::ValidationError(name, "expected a whole number, " + range + ", got '" + text + "'");
  };
  return command.add_option_function<std::string>(name, read, help)
      ->type_name("UINT")
      ->default_str(std::to_string(value));
}

std::string quoted(std::string_view word) {
  const bool plain =
      !word.empty() &&
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:=+@%") ==
          std::string_view::npos;
  if (plain) return std::string(word);
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace dermis::cli
