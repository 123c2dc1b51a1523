// SPDX-License-Identifier: MIT
#include "cli/failure.h"

#include <fmt/format.h>

#include <cstdio>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "base/core/known_names.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/settings_options.h"
#include "dermis/error.h"

namespace dermis::cli {
namespace {

constexpr int failure = 1, usage_error = 2, software_error = 70;

int fail(std::string line, int status = failure) {
  show_line("");  // a progress may be under way
  // Names of files may hold anything: a message stays one line.
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  std::fprintf(stderr, "dermis: %s\n", line.c_str());
  return status;
}

// The command that was given, else the program.
const CLI::App& command_of(const CLI::App& app) {
  const std::vector<const CLI::App*> given =
      app.get_subcommands([](const CLI::App* c) { return c->parsed(); });
  return given.empty() ? app : *given.front();
}

// Candidates for a word: commands, and options with a group; others are hidden.
std::vector<std::string> words_of(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; }))
    words.push_back(sub->get_name());
  for (const CLI::Option* option : command.get_options())
    if (option->nonpositional() && !option->get_group().empty())
      for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  return words;
}

// Says which word of the command line nothing takes, or nothing if each has a meaning.
std::string of_unknown_word(const CLI::App& app) {
  const std::vector<std::string> left = app.remaining(true);
  if (left.empty()) return {};
  const CLI::App& command = command_of(app);
  const std::string word = left.front().substr(0, left.front().find('='));
  const std::string meant = did_you_mean(word, words_of(command));

  const bool is_option = word.starts_with('-');
  if (&command == &app && !is_option) {
    std::vector<std::string> commands;
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
      commands.push_back(sub->get_name());
    return fmt::format("there is no command '{}'; {}{}", word, listed_names("", commands), meant);
  }
  const std::string place = &command == &app ? "" : command.get_name() + ": ";
  if (!is_option) return fmt::format("{}nothing takes the word '{}'{}", place, left.front(), meant);
  return fmt::format("{}there is no option '{}'{}", place, word,
                     meant.empty() ? "; --help-all shows all" : meant);
}

}  // namespace

int report_failure(const CLI::App& app) {
  try {
    throw;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      app.exit(error);  // prints help
      try {
        finish_output();
      } catch (const InputError& cut_off) { return fail(cut_off.what()); }
      return 0;
    }
    const std::string unknown = of_unknown_word(app);
    if (!unknown.empty()) return fail(unknown, usage_error);
    app.exit(error);
    return usage_error;
  } catch (const InternalError& error) {
    return fail(error.what(), software_error);
  } catch (const std::bad_alloc&) {
    return fail("too little memory");
  } catch (const std::system_error& error) {
    // A thread that cannot be started says no more than "resource temporarily unavailable".
    return fail(error.code() == std::errc::resource_unavailable_try_again
                    ? "the system allows no more threads or memory"
                    : error.what());
  } catch (const std::exception& error) { return fail(with_options(error.what(), app)); }
}

}  // namespace dermis::cli
