// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

#include "base/core/error.h"
#include "cli/command.h"

namespace dermis::cli {
namespace {

// The viewer's program is of the same build and reads the same words again.
void start_viewer(char** arguments) {
  std::error_code error;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  const std::filesystem::path viewer = here / "dermis-view";
  if (!std::filesystem::exists(viewer, error))
    throw input_error("view",
                      "this build has no viewer: {} is not there, because GLFW or Dear ImGui was not found "
                      "(apt install libglfw3-dev libimgui-dev). 'dermis render' draws to a file",
                      viewer.string());
  execv(viewer.c_str(), arguments);
  throw input_error(viewer.string(), "cannot be started: {}", std::strerror(errno));
}

}  // namespace

void add_view_command(CLI::App& app, char** arguments) {
  auto parsed = std::make_shared<ViewArguments>();
  add_view_options(app, *parsed)->callback([parsed, arguments] { start_viewer(arguments); });
}

}  // namespace dermis::cli
