// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/brief_log.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/profile_command.h"
#include "cli/progress.h"
#include "cli/settings_options.h"

namespace {

int fail(std::string line) {
  dermis::cli::show_line("");  // whatever was under way
  // Names of files may hold anything: a message stays one line.
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  std::fprintf(stderr, "dermis: %s\n", line.c_str());
  return 1;
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

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"dermis: human skin in real time, and what it costs"};
  app.set_version_flag("--version", DERMIS_VERSION);
  app.require_subcommand(1);
  app.formatter(std::make_shared<dermis::cli::HelpFormatter>());
  app.get_formatter()->column_width(38);
  app.option_defaults()->always_capture_default();

  for (int i = 0; i < argc; ++i) dermis::cli::command_line() += (i ? " " : "") + quoted(argv[i]);
  int exit_status = 0;
  dermis::cli::add_render_command(app, exit_status);
  dermis::cli::add_reference_command(app, exit_status);
  dermis::cli::add_plan_command(app, exit_status);
  dermis::cli::add_profile_command(app, exit_status);
  dermis::cli::add_compare_command(app, exit_status);
  dermis::cli::add_bench_command(app, exit_status);
  dermis::cli::add_info_command(app, exit_status);

  // 2: the command line cannot be parsed. 1: everything else that goes wrong, in one line.
  dermis::cli::BriefLog log(app);
  try {
    const std::vector<std::string> arguments = dermis::cli::join_lists({argv, argv + argc});
    std::vector<const char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(argument.c_str());
    app.parse(static_cast<int>(pointers.size()), pointers.data());
    log.finish();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::bad_alloc&) {
    return fail("too little memory");
  } catch (const std::system_error& error) {
    // A thread that cannot be started says no more than "resource temporarily unavailable".
    return fail(error.code() == std::errc::resource_unavailable_try_again
                    ? "the system allows no more threads or memory"
                    : error.what());
  } catch (const std::exception& error) { return fail(dermis::cli::with_options(error.what(), app)); }
  return exit_status;
}
