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
#include "cli/help.h"
#include "cli/version.h"
#include "dermis/error.h"
#include "viewer/app.h"

namespace {

void view(const dermis::cli::ViewArguments& a, const CLI::App& command, int& exit_status) {
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
  const std::string version = dermis::cli::version_text();
  dermis::cli::set_up_help(app);
  app.set_version_flag("--version", version, "show the version, and what it was built with, and end");
  app.require_subcommand(1);
  int exit_status = 0;

  auto arguments = std::make_shared<dermis::cli::ViewArguments>();
  CLI::App* command = dermis::cli::add_view_options(app, *arguments);
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
