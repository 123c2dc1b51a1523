// SPDX-License-Identifier: MIT
// dermis-view: what `dermis view` starts. A program of its own, so that the other commands need neither a
// window system nor its libraries.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/brief_log.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/failure.h"
#include "dermis/error.h"
#include "viewer/app.h"

namespace {

struct ViewArguments : dermis::cli::SceneArguments {
  dermis::cli::DeviceArguments on;
  bool scripted = false, live_shaders = false;
  std::string window = "1280x800";
};

void view(const ViewArguments& a, const CLI::App& command, int& exit_status) {
  dermis::viewer::AppOptions options;
  options.device = a.on.device;
  options.validate = a.on.validate;
  options.scripted = a.scripted;
  options.words = a.scenes;
  options.settings = a.settings;
  options.scene_options = a.options;
  if (std::sscanf(a.window.c_str(), "%dx%d", &options.width, &options.height) != 2 || options.width < 320 ||
      options.height < 180 || options.width > 16384 || options.height > 16384)
    throw dermis::InputError("--window", "expected WIDTHxHEIGHT from 320x180 on, got '" + a.window + "'");
  options.fixed_size = command.get_option("--size")->count() > 0;
  if (a.layout && a.scenes.size() > 1) {
    options.words.emplace_back("--layout");
    options.words.emplace_back(dermis::name_of(*a.layout));
  }
#ifdef DERMIS_LIVE_SHADERS
  if (a.live_shaders) {
    options.shader_folder = DERMIS_SHADER_FOLDER;
    options.shader_compiler = DERMIS_SHADER_COMPILER;
  }
#endif
  options.load = [&a](const dermis::Hooks& hooks) { return dermis::cli::open_scene(a, hooks); };
  exit_status = dermis::viewer::run(options);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"dermis: human skin in real time, and what it costs"};
  app.set_version_flag("--version", DERMIS_VERSION);
  app.require_subcommand(1);
  app.formatter(std::make_shared<dermis::cli::HelpFormatter>());
  app.get_formatter()->column_width(38);
  app.option_defaults()->always_capture_default();
  int exit_status = 0;

  CLI::App* command = app.add_subcommand("view", "look at a scene in a window, and change it");
  auto arguments = std::make_shared<ViewArguments>();
  dermis::cli::add_scene_arguments(*command, *arguments, dermis::cli::SceneUse::view);
  dermis::cli::add_device_arguments(*command, arguments->on);
  command->add_option("--window", arguments->window, "size of the window at first, pixels")->type_name("WxH");
  command->add_flag("--tell", arguments->scripted, "print what happens, a line each, for scripts");
#ifdef DERMIS_LIVE_SHADERS
  command->add_flag("--live-shaders", arguments->live_shaders,
                    "for developers: compile the shaders of " DERMIS_SHADER_FOLDER " whenever they change");
#endif
  command->callback([arguments, command, &exit_status] { view(*arguments, *command, exit_status); });

  dermis::cli::BriefLog log(app);
  try {
    const std::vector<std::string> words = dermis::cli::join_lists({argv, argv + argc});
    std::vector<const char*> pointers;
    for (const std::string& word : words) pointers.push_back(word.c_str());
    app.parse(static_cast<int>(pointers.size()), pointers.data());
    log.finish();
  } catch (...) { return dermis::cli::report_failure(app); }
  return exit_status;
}
