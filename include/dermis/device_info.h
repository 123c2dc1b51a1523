// SPDX-License-Identifier: MIT
/// The devices that Vulkan offers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace dermis {

struct DeviceInfo {
  std::string name, driver;
  std::string type;                ///< discrete, integrated, virtual, software, other
  std::string api;                 ///< version of Vulkan, "1.3.230"
  std::uint64_t memory_bytes = 0;  ///< its largest heap of its own
  /// Features that dermis needs and the device has not, a sentence each; empty: Renderer can use it.
  std::vector<std::string> missing;
};

/// Returns all devices, best first (discrete, integrated, virtual, software; unusable ones last), as
/// Renderer::Options::device numbers them. Empty without a driver.
std::vector<DeviceInfo> list_devices();

}  // namespace dermis
