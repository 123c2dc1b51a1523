// SPDX-License-Identifier: MIT
#include <memory>

#include "cli/command.h"
#include "cli/output.h"
#include "cli/progress.h"

namespace dermis::cli {

void add_plan_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand(
      "plan", "print the passes of a frame, what each reads and writes, and the memory; needs no device");
  auto arguments = std::make_shared<SceneArguments>();
  auto dot = std::make_shared<bool>(false);
  auto output = std::make_shared<std::string>("-");
  add_scene_arguments(*command, *arguments, SceneUse::plan);
  command->add_flag("--dot", *dot, "for Graphviz");
  command->add_option("-o,--output", *output, "file, or - for standard output")->type_name("FILE");
  command->callback([=] {
    check_scene_output(*arguments, {*output});
    const Scene scene = open_scene(*arguments);
    const CatchInterrupts here;
    const std::string plan = describe_plan(scene, arguments->settings, *dot, terminal_hooks());
    show_line("");
    write_text(*output, plan);
    save_settings(*arguments);
    save_scene(*arguments, scene);
  });
}

}  // namespace dermis::cli
