// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <vector>

#include "cli/brief_log.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/failure.h"
#include "cli/help.h"
#include "cli/manual/entries.h"
#include "cli/output.h"
#include "cli/profile_command.h"
#include "cli/version.h"

int main(int argc, char** argv) {
  CLI::App app{"dermis: human skin in real time, and what it costs"};
  const std::string version = dermis::cli::version_text();
  dermis::cli::set_up_help(app);
  app.set_version_flag("--version", version, "show the version, and what it was built with, and end");
  app.require_subcommand(1);

  for (int i = 0; i < argc; ++i) dermis::cli::command_line() += (i ? " " : "") + dermis::cli::quoted(argv[i]);
  int exit_status = 0;
  dermis::cli::add_render_command(app, exit_status);
  dermis::cli::add_sequence_command(app, exit_status);
  dermis::cli::add_view_command(app, argv);
  dermis::cli::add_reference_command(app, exit_status);
  dermis::cli::add_plan_command(app, exit_status);
  dermis::cli::add_profile_command(app, exit_status);
  dermis::cli::add_compare_command(app, exit_status);
  dermis::cli::add_bench_command(app, exit_status);
  dermis::cli::add_dataset_command(app, exit_status);
  dermis::cli::add_demo_command(app, exit_status);
  dermis::cli::add_info_command(app, exit_status);

  dermis::cli::manual::add_manual_options(app, DERMIS_VERSION);

  dermis::cli::BriefLog log(app);
  try {
    const std::vector<std::string> arguments = dermis::cli::join_lists({argv, argv + argc});
    std::vector<const char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(argument.c_str());
    app.parse(static_cast<int>(pointers.size()), pointers.data());
    log.finish();
    dermis::cli::finish_output();
  } catch (...) { return dermis::cli::report_failure(app); }
  return exit_status;
}
