// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "cli/manual/entries.h"

namespace dermis::cli::manual {
namespace {

constexpr const char* exit_status = R"(.SH EXIT STATUS
.TP
.B 0
done
.TP
.B 1
a file, a setting or the device cannot be used; one line on standard error says which and why
.TP
.B 2
the command line cannot be understood
.TP
.B 70
a mistake in dermis itself
.SH ENVIRONMENT
.TP
.B XDG_CACHE_HOME
what takes long to make is kept in its folder
.IR dermis ,
else in
.IR \(ti/.cache/dermis ;
.B dermis info \-\-cache
shows it
.TP
.B DERMIS_CACHE_LIMIT
megabytes that may be kept there
)";

// roff reads '\' everywhere, and '.' and '\'' where a line begins; '-' would become a hyphen.
std::string roff(std::string_view text) {
  std::string page;
  for (const char c : text) {
    if (page.empty() && (c == '.' || c == '\'')) page += "\\&";
    if (c == '\\')
      page += "\\e";
    else if (c == '-')
      page += "\\-";
    else if (c == '\'')
      page += "\\(aq";
    else if (c == '`')
      page += "\\(ga";
    else if (c == '^')
      page += "\\(ha";
    else if (c == '~')
      page += "\\(ti";
    else
      page += c == '\n' ? ' ' : c;
  }
  return page;
}

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

std::string paragraph_of(const OptionEntry& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back("\\fB" + roff(name) + "\\fR");
  std::string text = fmt::format(".TP\n{}", fmt::join(names, ", "));
  if (!option.type.empty()) text += fmt::format(" \\fI{}\\fR", roff(option.type));
  text += "\n" + roff(option.help) + "\n";
  if (!option.preset.empty()) text += fmt::format("(default: {})\n", roff(option.preset));
  return text;
}

// Each command has the options that show its help; the page names them once, of the program.
bool is_listed(const CommandEntry& command, const OptionEntry& option) {
  const std::string& name = option.names.back();
  return command.name.empty() || (name != "--help" && name != "--help-all");
}

// Titles in the order of their first options; what is positional comes first.
std::string options_of(const CommandEntry& command) {
  std::string text;
  std::vector<std::string> titles;
  for (const OptionEntry& option : command.options) {
    if (!is_listed(command, option)) continue;
    if (option.is_positional) text += paragraph_of(option);
    const bool is_new = std::find(titles.begin(), titles.end(), option.title) == titles.end();
    if (!option.is_positional && is_new) titles.push_back(option.title);
  }

  for (const std::string& title : titles) {
    text += fmt::format(".PP\n.I \"{}\"\n", roff(title));
    for (const OptionEntry& option : command.options)
      if (!option.is_positional && option.title == title && is_listed(command, option))
        text += paragraph_of(option);
  }
  return text;
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& version) {
  const std::vector<CommandEntry> commands = entries_of(app);
  std::string page = fmt::format(".TH DERMIS 1 \"\" \"dermis {}\" \"User Commands\"\n", roff(version));
  page += ".SH NAME\ndermis \\- human skin in real time, and what it costs\n";
  page += ".SH SYNOPSIS\n.B dermis\n.I command\n[\\fIoptions\\fR]\n";

  page += ".SH COMMANDS\n";
  for (const CommandEntry& command : commands)
    if (!command.name.empty())
      page += fmt::format(".TP\n.B {}\n{}\n", roff(command.name), roff(command.help));

  for (const CommandEntry& command : commands) {
    page += command.name.empty() ? ".SH OPTIONS\n"
                                 : fmt::format(".SH \"OPTIONS OF DERMIS {}\"\n", upper(command.name));
    page += options_of(command);
  }
  return page + exit_status;
}

}  // namespace dermis::cli::manual
