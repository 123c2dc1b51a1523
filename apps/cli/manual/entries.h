// SPDX-License-Identifier: MIT
/// The commands and options of a program as completions and the manual page need them, read from the program
/// itself.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace dermis::cli::manual {

struct OptionEntry {
  std::vector<std::string> names;  ///< "-o", "--output"; of a positional its name
  std::string type;                ///< as CLI11 has it, "studio|FILE"; empty: a flag
  std::string preset;              ///< the value that holds without it; empty: nothing that can be typed
  std::string help, title;
  std::vector<std::string> words;  ///< values that can be typed
  bool takes_file = false, takes_folder = false;
  bool is_list = false;  ///< several values, with commas
  bool is_repeatable = false;
  bool is_positional = false;
};

struct CommandEntry {
  std::string name, help;  ///< the program itself has no name
  std::vector<OptionEntry> options;
};

/// Returns the program, then its commands. Options without a group are hidden.
std::vector<CommandEntry> entries_of(const CLI::App& app);

/// Scripts for the shells, and a page for man(1).
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string man_page(const CLI::App& app, const std::string& version);

/// Adds --completions and --man, hidden, which print one of these and end the program with status 0.
void add_manual_options(CLI::App& app, const std::string& version);

}  // namespace dermis::cli::manual
