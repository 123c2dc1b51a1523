// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/command.h"
#include "dermis/error.h"
#include "gpu/device.h"

namespace dermis::cli {
namespace {

std::string as_text(const std::vector<gpu::DeviceSummary>& devices) {
  std::string text;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const gpu::DeviceSummary& d = devices[i];
    text += fmt::format("{}: {}\n   {}, Vulkan {}, {:.1f} GiB, driver {}\n", i, d.name, d.type, d.api,
                        static_cast<double>(d.memory_bytes) / (std::uint64_t{1} << 30),
                        d.driver.empty() ? "unknown" : d.driver);
    if (d.missing.empty()) text += "   usable\n";
    for (const std::string& missing : d.missing) text += fmt::format("   cannot be used: {}\n", missing);
  }
  return text;
}

std::string as_json(const std::vector<gpu::DeviceSummary>& devices) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const gpu::DeviceSummary& d = devices[i];
    list.push_back({{"index", i},
                    {"name", d.name},
                    {"type", d.type},
                    {"driver", d.driver},
                    {"api", d.api},
                    {"memory_bytes", d.memory_bytes},
                    {"usable", d.missing.empty()},
                    {"missing", d.missing}});
  }
  return nlohmann::ordered_json{{"devices", list}}.dump(2, ' ', false,
                                                        nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

}  // namespace

int run_info(bool json) {
  const std::vector<gpu::DeviceSummary> devices = gpu::list_devices();
  std::fputs((json ? as_json(devices) : as_text(devices)).c_str(), stdout);
  if (std::ranges::any_of(devices, [](const gpu::DeviceSummary& d) { return d.missing.empty(); })) return 0;
  try {
    const gpu::Device device(gpu::Device::Options{});  // says why, in the words that every other command uses
  } catch (const DeviceError& error) {
    std::fputs(fmt::format("dermis: {}\n", error.what()).c_str(), stderr);
  }
  return 1;
}

void add_info_command(CLI::App& app, int& exit_status) {
  CLI::App* command =
      app.add_subcommand("info", "list the devices, and what is missing on those that cannot be used");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "as JSON");
  command->callback([json, &exit_status] { exit_status = run_info(*json); });
}

}  // namespace dermis::cli
