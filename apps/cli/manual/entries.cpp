// SPDX-License-Identifier: MIT
#include "cli/manual/entries.h"

#include <fmt/format.h>

#include <cstdio>

#include "cli/help.h"

namespace dermis::cli::manual {
namespace {

OptionEntry entry_of(const CLI::Option& option, const HelpFormatter& formatter) {
  OptionEntry entry{.help = formatter.make_option_desc(&option), .title = title_of(option)};
  entry.is_positional = option.get_positional();
  if (entry.is_positional) entry.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  if (option.get_type_size() == 0) return entry;

  entry.type = option.get_type_name();
  entry.preset = option.get_default_str();
  for (const std::string& part : parts_of_type(option)) {
    if (is_word(part)) entry.words.push_back(part);
    entry.takes_file = entry.takes_file || part == "FILE";
    entry.takes_folder = entry.takes_folder || part == "FOLDER";
  }
  entry.is_list = option.get_delimiter() != '\0';
  entry.is_repeatable = option.get_expected_max() > 1 && !entry.is_list;
  return entry;
}

CommandEntry entry_of(const CLI::App& command, const std::string& name) {
  const HelpFormatter formatter;
  CommandEntry entry{.name = name, .help = command.get_description(), .options = {}};
  for (const CLI::Option* option : command.get_options())
    if (!option->get_group().empty()) entry.options.push_back(entry_of(*option, formatter));
  return entry;
}

}  // namespace

std::vector<CommandEntry> entries_of(const CLI::App& app) {
  std::vector<CommandEntry> entries{entry_of(app, "")};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    entries.push_back(entry_of(*command, command->get_name()));
  return entries;
}

void add_manual_options(CLI::App& app, const std::string& version) {
  const auto print = [](const std::string& text) {
    std::fputs(text.c_str(), stdout);
    throw CLI::Success();
  };
  const auto completions = [&app, print](const std::string& shell) {
    if (shell != "bash" && shell != "zsh")
      throw CLI::ValidationError("--completions", unknown_name(shell, {"bash", "zsh"}));
    print(shell == "bash" ? bash_completion(app) : zsh_completion(app));
  };
  app.add_option_function<std::string>("--completions", completions, "print completions for a shell")
      ->type_name("bash|zsh")
      ->group("");
  app.add_flag_callback(
         "--man", [&app, print, version] { print(man_page(app, version)); }, "print the manual page")
      ->group("");
}

}  // namespace dermis::cli::manual
