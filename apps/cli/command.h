// SPDX-License-Identifier: MIT
/// The commands of the program. Each adds itself to the application; its callback returns the exit status through the shared variable.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "dermis/renderer.h"

namespace dermis::cli {

void add_compare_command(CLI::App& app, int& exit_status);
void add_info_command(CLI::App& app, int& exit_status);
void add_plan_command(CLI::App& app, int& exit_status);
void add_render_command(CLI::App& app, int& exit_status);

/// What render, plan and later commands have in common.
struct SceneArguments {
  std::string scene;  ///< path; empty: the built-in head
  SceneOptions options;
  RenderSettings settings;
};
void add_scene_arguments(CLI::App& command, SceneArguments& arguments);
Scene open_scene(const SceneArguments& arguments);

/// Text to a file, atomically, or to standard output if path is "-".
void write_text(const std::string& path, const std::string& text);

}  // namespace dermis::cli
