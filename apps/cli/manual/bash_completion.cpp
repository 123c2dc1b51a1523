// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include "cli/manual/entries.h"

namespace dermis::cli::manual {
namespace {

// Puts the words together again that bash parts at ':' and '='; then the tables say what may stand there.
constexpr const char* bash_head = R"(# Completions of dermis for bash, written by 'dermis --completions bash'.
_dermis() {
  local words=() part glue=''
  for part in "${COMP_WORDS[@]:1:COMP_CWORD}"; do
    if [[ $part == = ]]; then
      glue=''
      words+=('')
      continue
    elif [[ ($part == : || -n $glue) && ${#words[@]} -gt 0 ]]; then
      words[-1]+=$part
    elif [[ ${#words[@]} -gt 0 && -z ${words[-1]} ]]; then
      words[-1]=$part
    else
      words+=("$part")
    fi
    [[ $part == : ]] && glue=1 || glue=''
  done

  local current=${words[-1]} option='' command='' names='' values='' files='' list='' before=''
  if ((${#words[@]} > 1)); then
    command=${words[0]}
    option=${words[-2]}
  fi
  case $command in
)";

constexpr const char* bash_foot = R"(  esac

  [[ $current == -* && -n $names ]] && values=$names files=''
  if [[ -n $list && $current == *,* ]]; then
    before=${current%,*},
    current=${current##*,}
  fi
  COMPREPLY=($(compgen -P "$before" -W "$values" -- "$current"))
  if [[ -n $files ]]; then
    compopt -o filenames 2> /dev/null
    local name
    while IFS= read -r name; do COMPREPLY+=("$name"); done < <(compgen -"$files" -- "$current")
  fi

  # bash replaces what stands behind the last ':' alone.
  if [[ $current == *:* && $COMP_WORDBREAKS == *:* ]]; then
    local i colon=${current%"${current##*:}"}
    for i in "${!COMPREPLY[@]}"; do COMPREPLY[i]=${COMPREPLY[i]#"$colon"}; done
  fi
}
complete -F _dermis dermis
)";

// The values of one option, or of what stands where no option is.
std::string values_of(const OptionEntry& option) {
  std::string text;
  if (!option.words.empty()) text += fmt::format("values='{}' ", fmt::join(option.words, " "));
  if (option.takes_file) text += "files=f ";
  if (option.takes_folder && !option.takes_file) text += "files=d ";
  if (option.is_list && !option.words.empty()) text += "list=1 ";
  return text.empty() ? ": " : text;
}

std::string case_of(const CommandEntry& command) {
  std::vector<std::string> names;
  std::string cases;
  OptionEntry positional;  // of all words that are no options: a shell does not count them
  bool has_positional = false;
  for (const OptionEntry& option : command.options) {
    if (option.is_positional) {
      positional.words.insert(positional.words.end(), option.words.begin(), option.words.end());
      positional.takes_file = positional.takes_file || option.takes_file;
      positional.takes_folder = positional.takes_folder || option.takes_folder;
      has_positional = true;
      continue;
    }
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (!option.type.empty())
      cases += fmt::format("    {}) {};;\n", fmt::join(option.names, "|"), values_of(option));
  }
  return fmt::format("  {})\n    case $option in\n{}    *) names='{}' {};;\n    esac\n    ;;\n", command.name,
                     cases, fmt::join(names, " "), has_positional ? values_of(positional) : "files=f ");
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  const std::vector<CommandEntry> commands = entries_of(app);
  std::vector<std::string> names, options;
  std::string cases;
  for (const CommandEntry& command : commands) {
    if (command.name.empty()) {
      for (const OptionEntry& option : command.options)
        options.insert(options.end(), option.names.begin(), option.names.end());
      continue;
    }
    names.push_back(command.name);
    cases += case_of(command);
  }
  return fmt::format("{}  '') names='{}' values='{}' ;;\n{}{}", bash_head, fmt::join(options, " "),
                     fmt::join(names, " "), cases, bash_foot);
}

}  // namespace dermis::cli::manual
