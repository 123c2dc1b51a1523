// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/core/cache.h"
#include "cli/command.h"
#include "dermis/error.h"
#include "gpu/device.h"

namespace dermis::cli {
namespace {

std::string as_text(const std::vector<DeviceInfo>& devices) {
  std::string text;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const DeviceInfo& d = devices[i];
    text += fmt::format("{}: {}\n   {}, Vulkan {}, {:.1f} GiB, driver {}\n", i, d.name, d.type, d.api,
                        static_cast<double>(d.memory_bytes) / (std::uint64_t{1} << 30),
                        d.driver.empty() ? "unknown" : d.driver);
    if (d.missing.empty()) text += "   usable\n";
    for (const std::string& missing : d.missing) text += fmt::format("   cannot be used: {}\n", missing);
  }
  return text;
}

std::string dumped(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string as_json(const std::vector<DeviceInfo>& devices) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const DeviceInfo& d = devices[i];
    list.push_back({{"index", i},
                    {"name", d.name},
                    {"type", d.type},
                    {"driver", d.driver},
                    {"api", d.api},
                    {"memory_bytes", d.memory_bytes},
                    {"usable", d.missing.empty()},
                    {"missing", d.missing}});
  }
  return dumped(nlohmann::ordered_json{{"devices", list}});
}

std::string cache_as_text(const std::string& folder, const std::vector<cache::Usage>& usage, bool cleared) {
  std::string text = fmt::format("{}\n", folder.empty() ? "nothing is kept: neither XDG_CACHE_HOME nor HOME "
                                                          "is set"
                                                        : folder);

  std::uint64_t files = 0, bytes = 0;
  const auto line = [](std::string_view kind, std::uint64_t count, std::uint64_t size) {
    return fmt::format("   {:<12} {:>6} file{} {:>10.1f} MB\n", kind, count, count == 1 ? " " : "s",
                       static_cast<double>(size) / 1e6);
  };

  for (const cache::Usage& kind : usage) {
    text += line(kind.kind, kind.files, kind.bytes);
    files += kind.files;
    bytes += kind.bytes;
  }
  text += line(cleared ? "removed" : "together", files, bytes);

  if (!cleared)
    text += fmt::format("   limit {} MB; the environment variable DERMIS_CACHE_LIMIT sets another\n",
                        cache::limit_bytes() / 1'000'000);
  return text;
}

std::string cache_as_json(const std::string& folder, const std::vector<cache::Usage>& usage, bool cleared) {
  nlohmann::ordered_json kinds = nlohmann::ordered_json::object();
  for (const cache::Usage& kind : usage) kinds[kind.kind] = {{"files", kind.files}, {"bytes", kind.bytes}};
  return dumped({{"cache",
                  {{"folder", folder},
                   {"limit_bytes", cache::limit_bytes()},
                   {"cleared", cleared},
                   {"kinds", std::move(kinds)}}}});
}

int run_cache(bool json, bool clear) {
  const std::filesystem::path folder = cache::default_folder();
  const std::vector<cache::Usage> usage = clear ? cache::clear(folder) : cache::usage(folder);
  const auto print = json ? cache_as_json : cache_as_text;
  std::fputs(print(folder.string(), usage, clear).c_str(), stdout);
  return 0;
}

}  // namespace

int run_info(bool json) {
  const std::vector<DeviceInfo> devices = gpu::list_devices();
  std::fputs((json ? as_json(devices) : as_text(devices)).c_str(), stdout);
  if (std::ranges::any_of(devices, [](const DeviceInfo& d) { return d.missing.empty(); })) return 0;
  try {
    const gpu::Device device(gpu::Device::Options{});  // says why, in the words that every other command uses
  } catch (const DeviceError& error) {
    std::fputs(fmt::format("dermis: {}\n", error.what()).c_str(), stderr);
  }
  return 1;
}

void add_info_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "info",
      "list the devices, and what is missing on those that cannot be used; what is kept between runs");
  struct Arguments {
    bool json = false, cache = false, clear = false;
  };
  auto arguments = std::make_shared<Arguments>();
  command->add_flag("--json", arguments->json, "as JSON");
  command->add_flag("--cache", arguments->cache,
                    "instead: the folder of what is kept between runs, files and bytes of each kind");
  command->add_flag("--clear-cache", arguments->clear, "instead: remove these files, and say what they were");
  command->callback([arguments, &exit_status] {
    const bool about_cache = arguments->cache || arguments->clear;
    exit_status = about_cache ? run_cache(arguments->json, arguments->clear) : run_info(arguments->json);
  });
}

}  // namespace dermis::cli
