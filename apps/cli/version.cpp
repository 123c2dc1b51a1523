// SPDX-License-Identifier: MIT
#include "cli/version.h"

#include <fmt/format.h>
#include <vulkan/vulkan_core.h>

namespace dermis::cli {
namespace {

std::string vulkan_headers() {
  constexpr auto version = VK_HEADER_VERSION_COMPLETE;
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

}  // namespace

// The macros are written by apps/cli/CMakeLists.txt.
std::string version_text() {
  return fmt::format(
      "dermis {} ({})\nbuilt by {}, {}, for {}\nVulkan headers {}, needs Vulkan 1.3\nlibraries: {}",
      DERMIS_VERSION, commit(), DERMIS_COMPILER, DERMIS_BUILD, DERMIS_SYSTEM, vulkan_headers(),
      DERMIS_LIBRARIES);
}

}  // namespace dermis::cli
