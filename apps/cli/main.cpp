// SPDX-License-Identifier: MIT
#include <cstdio>
#include <new>

#include "cli/command.h"

int main(int argc, char** argv) {
  CLI::App app{"dermis: human skin in real time, and what it costs"};
  app.set_version_flag("--version", DERMIS_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(38);
  app.option_defaults()->always_capture_default();

  int exit_status = 0;
  dermis::cli::add_render_command(app, exit_status);
  dermis::cli::add_plan_command(app, exit_status);
  dermis::cli::add_info_command(app, exit_status);

  // 2: the command line cannot be parsed. 1: everything else that goes wrong, in one line.
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::bad_alloc&) {
    std::fputs("dermis: too little memory\n", stderr);
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dermis: %s\n", error.what());
    return 1;
  }
  return exit_status;
}
