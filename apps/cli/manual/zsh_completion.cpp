// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <string_view>

#include "cli/manual/entries.h"

namespace dermis::cli::manual {
namespace {

constexpr const char* zsh_head = R"(#compdef dermis
# Completions of dermis for zsh, written by 'dermis --completions zsh'.
_dermis_words_or_files() {
  compadd -- "$@"
  _files
}

_dermis() {
  local context state line
  typeset -A opt_args
)";

constexpr const char* zsh_foot = R"(      esac
      ;;
  esac
}

_dermis "$@"
)";

// Within single quotes, and within the parts of a specification, where zsh reads '[', ']', ':' and '\'.
std::string quoted_part(std::string_view text) {
  std::string quoted;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') quoted += '\\';
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted;
}

std::string action_of(const OptionEntry& option) {
  std::vector<std::string> words;
  for (const std::string& word : option.words) words.push_back(quoted_part(word));
  if (option.takes_folder) return "_files -/";
  if (option.takes_file)
    return words.empty() ? "_files" : fmt::format(" _dermis_words_or_files {}", fmt::join(words, " "));
  if (words.empty()) return "";
  return option.is_list ? fmt::format(" _values -s , value {}", fmt::join(words, " "))
                        : fmt::format("({})", fmt::join(words, " "));
}

std::string specification_of(const OptionEntry& option) {
  const std::string value =
      option.type.empty() ? "" : fmt::format(":{}:{}", quoted_part(option.type), action_of(option));
  if (option.is_positional)
    return fmt::format("'{}{}'", option.is_repeatable ? "*" : "", value.empty() ? ":word:" : value);

  const std::string repeat = option.is_repeatable ? "*" : "";
  const std::string excluded = option.is_repeatable ? "" : fmt::format("({})", fmt::join(option.names, " "));
  std::vector<std::string> all;
  for (const std::string& name : option.names)
    all.push_back(fmt::format("'{}{}{}[{}]{}'", excluded, repeat, name, quoted_part(option.help), value));
  return fmt::format("{}", fmt::join(all, " \\\n            "));
}

std::string arguments_of(const CommandEntry& command) {
  std::string text;
  for (const OptionEntry& option : command.options) text += " \\\n            " + specification_of(option);
  return text;
}

}  // namespace

std::string zsh_completion(const CLI::App& app) {
  const std::vector<CommandEntry> commands = entries_of(app);
  std::string names, cases;
  for (const CommandEntry& command : commands) {
    if (command.name.empty()) continue;
    names += fmt::format("    '{}:{}'\n", command.name, quoted_part(command.help));
    cases += fmt::format("        {})\n          _arguments{}\n          ;;\n", command.name,
                         arguments_of(command));
  }
  return fmt::format(
      "{}  local -a commands=(\n{}  )\n  _arguments -C{} \\\n            '1:command:->command' "
      "'*::argument:->argument'\n"
      "  case $state in\n    command) _describe command commands ;;\n    argument)\n      case $words[1] in\n"
      "{}{}",
      zsh_head, names, arguments_of(commands.front()), cases, zsh_foot);
}

}  // namespace dermis::cli::manual
