// SPDX-License-Identifier: MIT
/// The commands of the program. Each adds itself to the application; its callback returns the exit status
/// through the shared variable.
#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "api/playing.h"
#include "base/settings/json.h"
#include "cli/layout.h"
#include "dermis/reference.h"
#include "dermis/renderer.h"

namespace dermis::cli {

void add_bench_command(CLI::App& app, int& exit_status);
void add_compare_command(CLI::App& app, int& exit_status);
void add_dataset_command(CLI::App& app, int& exit_status);
void add_demo_command(CLI::App& app, int& exit_status);
void add_info_command(CLI::App& app, int& exit_status);
void add_plan_command(CLI::App& app, int& exit_status);
void add_reference_command(CLI::App& app, int& exit_status);
void add_render_command(CLI::App& app, int& exit_status);
void add_sequence_command(CLI::App& app, int& exit_status);
/// Starts the program of the viewer, which lies beside this one.
void add_view_command(CLI::App& app, char** arguments);

/// The reference knows no light maps, no shadow maps, no bloom and one head. A comparison has both: what
/// would be ambiguous is called
/// --scene (the file), --msaa (the renderer's samples), --techniques. The benchmark has lists of heads and
/// distances, and chooses technique and optimisations itself. A sequence draws each frame once, and may turn
/// its camera from frame to frame.
enum class SceneUse { render, view, sequence, plan, reference, comparison, bench };

/// Arguments that render, plan, reference and later commands share.
struct SceneArguments {
  SceneUse use = SceneUse::render;
  std::string scene;                ///< path; empty: the built-in head. Of commands that take one file
  std::vector<std::string> scenes;  ///< the same of those that take several; none: the built-in head
  std::optional<Layout> layout;
  std::string save_settings, save_scene;  ///< files; empty: none
  SceneOptions options;
  RenderSettings settings;
  std::optional<ReferenceSettings> reference;  ///< of commands that compute ground truth
};
void add_scene_arguments(CLI::App& command, SceneArguments& arguments, SceneUse use);
/// Reads WIDTHxHEIGHT; false for anything else. CLI11 turns that into exit status 2; sizes that parse but
/// make no sense are refused by the renderer.
bool parse_size(const std::string& text, OutputSettings& output);

/// A scene, and what of it plays the clip of --clip and --time: loaded at the begin of the clip, not posed
/// yet.
struct PlayingScene {
  Scene scene;
  std::vector<api::Playing> playing;
};
/// Shows on a terminal how far the loading is.
PlayingScene open_playing_scene(const SceneArguments& arguments);
PlayingScene open_playing_scene(const SceneArguments& arguments, const Hooks& hooks);
/// Likewise, and puts it in the pose of --time.
Scene open_scene(const SceneArguments& arguments);
Scene open_scene(const SceneArguments& arguments, const Hooks& hooks);

/// Where a command draws.
struct DeviceArguments {
  std::string device = "best";
  bool validate = false;
};
/// --device and --validate.
void add_device_arguments(CLI::App& command, DeviceArguments& arguments);
CLI::Option* add_device_option(CLI::App& command, std::string& device);

/// Arguments of the viewer.
struct ViewArguments : SceneArguments {
  DeviceArguments on;
  bool scripted = false, live_shaders = false;
  std::string window = "1280x800";
};
/// Adds the command `view` with its options, for the viewer's program and for the one that starts it.
CLI::App* add_view_options(CLI::App& app, ViewArguments& arguments);

/// Prints what the validation layer has said; returns whether it has said something.
bool tell_validation_messages(const Renderer& renderer);
/// Returns the content of --save-settings, which a result holds under `settings`.
SettingsFile settings_file(const SceneArguments& arguments);
/// Writes the settings to the file that --save-settings names, if it does.
void save_settings(const SceneArguments& arguments);
/// Throws InputError if the file of --save-scene cannot be written, or is one of `outputs` too.
void check_scene_output(const SceneArguments& arguments, std::initializer_list<std::string> outputs);
/// Writes the scene to the file that --save-scene names, if it does.
void save_scene(const SceneArguments& arguments, const Scene& scene);

/// The title of the options of ground truth in the help.
inline constexpr const char* truth_group = "Ground truth";

/// InputError: not .png or .exr, or it cannot be written there.
void check_picture_name(const std::string& path);

/// The command line as a shell would take it; main() sets it.
std::string& command_line();

}  // namespace dermis::cli
