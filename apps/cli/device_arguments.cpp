// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/help.h"

namespace dermis::cli {

CLI::Option* add_device_option(CLI::App& command, std::string& device) {
  return command
      .add_option("--device", device, "where to draw: best, an index or a part of a name of `dermis info`")
      ->type_name("best|NAME|INDEX");
}

void add_device_arguments(CLI::App& command, DeviceArguments& arguments) {
  add_device_option(command, arguments.device);
  rare(
      command.add_flag("--validate", arguments.validate,
                       "run under the Vulkan validation layer; its messages end the run with exit status 1"));
}

bool tell_validation_messages(const Renderer& renderer) {
  const std::vector<std::string> messages = renderer.validation_messages();
  for (const std::string& message : messages) fmt::print(stderr, "dermis: validation: {}\n", message);
  if (!messages.empty())
    fmt::print(stderr, "dermis: {} validation message{}\n", messages.size(), messages.size() == 1 ? "" : "s");
  return !messages.empty();
}

}  // namespace dermis::cli
