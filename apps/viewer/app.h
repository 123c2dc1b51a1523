// SPDX-License-Identifier: MIT
/// The viewer: a window, the document in it, and the threads that draw and read for it.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/model/background.h"
#include "viewer/model/opening.h"
#include "viewer/model/saving.h"
#include "viewer/panels/desk.h"

namespace dermis::viewer {

struct AppOptions {
  std::string device = "best";
  bool validate = false;
  int width = 1280, height = 800;  ///< of the window
  bool fixed_size = false;         ///< pictures have the size of the settings
  std::vector<std::string> words;  ///< that name the scene on a command line
  /// Loads the scene that the window opens with. Takes seconds.
  std::function<Scene(const Hooks&)> load;
  SceneOptions scene_options{};
  RenderSettings settings{};
  /// Shaders that are compiled while it runs, and what compiles them; empty: those of the build.
  std::string shader_folder{}, shader_compiler{};
  bool scripted = false;  ///< tells on standard output what happens, a line each, for tests
};

/// Runs until the window is closed. Returns the exit status: 1 if the validation layer has said something.
/// Throws DeviceError: no display, or no device that draws in it.
int run(const AppOptions& options);

}  // namespace dermis::viewer
