// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include "cli/help.h"

namespace dermis::cli {

CLI::App* add_view_options(CLI::App& app, ViewArguments& arguments) {
  CLI::App* command = app.add_subcommand("view", "look at a scene in a window, and change it");
  add_scene_arguments(*command, arguments, SceneUse::view);
  add_device_arguments(*command, arguments.on);
  command->add_option("--window", arguments.window, "size of the window at first, pixels")->type_name("WxH");
  rare(command->add_flag("--tell", arguments.scripted, "print what happens, a line each, for scripts"));
#ifdef DERMIS_LIVE_SHADERS
  rare(command->add_flag("--live-shaders", arguments.live_shaders,
                         "for developers: compile the shaders of the source tree whenever they change"));
#endif
  return command;
}

}  // namespace dermis::cli
