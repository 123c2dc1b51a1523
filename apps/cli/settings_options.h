// SPDX-License-Identifier: MIT
/// Options of the command line from the rows of settings (src/base/settings/fields.h).
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>

#include "base/core/fields.h"
#include "base/core/known_names.h"
#include "base/settings/check.h"
#include "base/settings/names.h"
#include "cli/command_line.h"
#include "cli/help.h"

namespace dermis::cli {

/// Returns the help of an option: that of the row with unit, and the value that holds without it.
std::string help_of(const About& about);

/// The row's help with its range: "terms of the sum, 1 to 8".
std::string help_with_range(const About& about);

/// Shows members of settings in a message with their options: "camera.fov_deg (--fov) must be ...". Options
/// that the command which runs does not have are left out.
std::string with_options(std::string message, const CLI::App& app);

/// Puts the option of a row under a title, and leaves it to --help-all unless the row is common.
CLI::Option* file_under(const std::string& title, const About& about, CLI::Option* option);

/// One option, whose kind follows from the type of the value. Its value is checked when it is used.
struct AddOption {
  CLI::App& command;

  template <class Value>
  CLI::Option* operator()(const std::string& name, const About& about, Value& value) const {
    const std::string help = help_of(about);
    if constexpr (std::is_enum_v<Value>)
      return add_named(name, about, value);
    else if constexpr (std::is_same_v<Value, std::uint64_t>)
      return add_count(command, name, value, help,
                       std::isfinite(about.most) ? range_text(about) : "0 to 2^64 - 1");
    else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
      return with_values(about,
                         command.add_option(name, value, help)->allow_extra_args(false)->default_str(""));
    else if constexpr (std::is_same_v<Value, bool>)
      return about.on.empty() ? command.add_flag(name, value, help) : add_switch(name, about, value);
    else
      return with_values(about, command.add_option(name, value, help));
  }

  template <class Value>
  CLI::Option* operator()(const std::string& name, const About& about, std::optional<Value>& value) const {
    const std::string help = help_of(about);
    if constexpr (std::is_same_v<Value, double>)
      if (about.none.find(' ') == std::string_view::npos) return add_number_or(name, about, value);
    return with_values(about, command.add_option(name, value, help));
  }

  CLI::Option* operator()(const std::string& name, const About& about, std::array<double, 2>& value) const;
  CLI::Option* operator()(const std::string& name, const About& about,
                          std::optional<std::array<double, 3>>& value) const;

 private:
  template <class Enum>
  CLI::Option* add_named(const std::string& name, const About& about, Enum& value) const {
    const auto read = [&value, name](const std::string& text) { value = find_name<Enum>(name, text); };
    return command.add_option_function<std::string>(name, read, help_of(about))
        ->type_name(one_of(names_of<Enum>))
        ->default_str(std::string(name_of(value)));
  }

  /// Adds an option whose value is one of two words, or true or false, as in JSON.
  CLI::Option* add_switch(const std::string& name, const About& about, bool& value) const {
    const std::string on(about.on), off(about.off);
    const auto read = [&value, name, on, off](const std::string& text) {
      const bool is_on = text == on || text == "true";
      if (!is_on && text != off && text != "false")
        throw CLI::ValidationError(name, unknown_name(text, {on, off}));
      value = is_on;
    };
    return command.add_option_function<std::string>(name, read, help_of(about))
        ->type_name(one_of({on, off}))
        ->default_str(value ? on : off);
  }
  static CLI::Option* with_values(const About& about, CLI::Option* option);
  CLI::Option* add_number_or(const std::string& name, const About& about, std::optional<double>& value) const;
};

}  // namespace dermis::cli
