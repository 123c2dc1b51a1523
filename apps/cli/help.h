// SPDX-License-Identifier: MIT
/// Help of a program and its commands: the common ones by --help, all by --help-all.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/core/known_names.h"

namespace dermis::cli {

/// Leaves an option to --help-all; its group is chosen before. Returns it.
CLI::Option* rare(CLI::Option* option);
bool is_rare(const CLI::Option& option);
/// Returns the group of an option as people read it.
std::string title_of(const CLI::Option& option);

/// Returns the type of an option that takes one of these names: "raster|compute". Words are what can be
/// typed, a part with a capital stands for something: "studio|FILE".
std::string one_of(const KnownNames& names);
/// Returns the parts of such a type.
std::vector<std::string> parts_of_type(const CLI::Option& option);
/// Returns whether a part of a type is a word to type.
bool is_word(std::string_view part);

/// Gives a program its help, before it gets commands.
void set_up_help(CLI::App& app);

/// Shows an option as it is to be typed, the words of a long type in its description. CLI11 adds "..." to
/// whatever holds several values and "x 2" to pairs, also where a comma parts them or where the option has to
/// be repeated.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace dermis::cli
