// SPDX-License-Identifier: MIT
#include "cli/help.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string_view>
#include <vector>

namespace dermis::cli {
namespace {

// CLI11 knows an option's group and nothing else of this kind. An empty group hides an option altogether.
constexpr std::string_view rare_mark = " (rare)";

constexpr std::size_t longest_type = 24;  // as it stands beside the name of an option

using OptionList = std::vector<const CLI::Option*>;

OptionList listed_options(const CLI::App& app, bool all) {
  return app.get_options([all](const CLI::Option* option) {
    return option->nonpositional() && !option->get_group().empty() && (all || !is_rare(*option));
  });
}

// The titles in the order of their first options.
std::vector<std::string> titles_of(const OptionList& options) {
  std::vector<std::string> titles;
  for (const CLI::Option* option : options)
    if (std::find(titles.begin(), titles.end(), title_of(*option)) == titles.end())
      titles.push_back(title_of(*option));
  return titles;
}

bool is_long(const CLI::Option& option) { return option.get_type_name().size() > longest_type; }

// "natural|neutral|agx|filmic|srgb|linear" is a NAME, "black|studio|environment|#RRGGBB" a NAME|#RRGGBB.
std::string short_type(const CLI::Option& option) {
  if (!is_long(option)) return option.get_type_name();
  std::string type = "NAME";
  for (const std::string& part : parts_of_type(option))
    if (!is_word(part)) type += "|" + part;
  return type;
}

std::string last_line(const CLI::App& app, const std::string& name, std::size_t shown) {
  if (!app.get_subcommands([](const CLI::App*) { return true; }).empty())
    return fmt::format(
        "\n{0} COMMAND --help shows the options of a command, {0} --help-all shows all of all commands\n",
        name);
  const std::size_t count = listed_options(app, true).size();
  return shown < count ? fmt::format("\n{} --help-all shows all {} options\n", name, count) : "";
}

}  // namespace

CLI::Option* rare(CLI::Option* option) {
  if (!is_rare(*option)) option->group(option->get_group() + std::string(rare_mark));
  return option;
}

bool is_rare(const CLI::Option& option) { return std::string_view(option.get_group()).ends_with(rare_mark); }

std::string title_of(const CLI::Option& option) {
  const std::string& group = option.get_group();
  return is_rare(option) ? group.substr(0, group.size() - rare_mark.size()) : group;
}

std::string one_of(const KnownNames& names) { return fmt::format("{}", fmt::join(names.all(), "|")); }

std::vector<std::string> parts_of_type(const CLI::Option& option) {
  std::istringstream type(option.get_type_name());
  std::vector<std::string> parts;
  for (std::string part; std::getline(type, part, '|');) parts.push_back(part);
  return parts;
}

bool is_word(std::string_view part) {
  return part.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string_view::npos;
}

void set_up_help(CLI::App& app) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_formatter()->column_width(38);
  app.set_help_flag("-h,--help", "show the options that most people need, and end");
  app.set_help_all_flag("--help-all", "show all options, and end");
  app.option_defaults()->always_capture_default();
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  // A command within the help of its program: CLI11 gives its name alone.
  if (mode == CLI::AppFormatMode::Sub) name = app->get_parent()->get_name() + " " + app->get_name();
  const bool all = mode != CLI::AppFormatMode::Normal;

  std::string text = make_description(app) + make_usage(app, name) + make_positionals(app);
  const OptionList options = listed_options(*app, all);
  for (const std::string& title : titles_of(options)) {
    OptionList of_title;
    for (const CLI::Option* option : options)
      if (title_of(*option) == title) of_title.push_back(option);
    text += make_group(title, false, of_title);
  }

  text += make_subcommands(app, mode);
  return all ? text : text + last_line(*app, name, options.size());
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  std::string text = CLI::Formatter::make_option_opts(option);
  const auto remove = [&text](const std::string& part) {
    if (const std::size_t at = text.find(part); at != std::string::npos) text.erase(at, part.size());
  };

  const std::string type = option->get_type_name();
  const bool is_list = option->get_delimiter() != '\0' && type.find('|') != std::string::npos;
  if (const std::size_t at = text.find(type); !type.empty() && at != std::string::npos)
    text.replace(at, type.size(), short_type(*option) + (is_list ? ",.." : ""));

  // The name of the type shows commas and pairs; what may be repeated says so in its description.
  if (option->get_delimiter() != '\0' || !option->get_allow_extra_args()) remove(" ...");
  if (type.find_first_of(", ") != std::string::npos) remove(" x " + std::to_string(option->get_expected()));
  return text;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  if (!is_long(*option)) return text;
  std::string words;
  for (const std::string& part : parts_of_type(*option)) {
    if (!is_word(part)) continue;
    if (words.empty() && text.find(part) != std::string::npos) return text;  // it explains them
    words += (words.empty() ? "" : ", ") + part;
  }
  return words.empty() ? text : text + ": " + words;
}

}  // namespace dermis::cli
