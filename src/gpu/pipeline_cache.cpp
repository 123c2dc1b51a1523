// SPDX-License-Identifier: MIT
#include "gpu/pipeline_cache.h"

#include <cstdint>
#include <cstring>

#include "core/error.h"
#include "core/file.h"
#include "core/log.h"

namespace dermis::gpu {
namespace {

constexpr std::uint64_t limit_bytes = std::uint64_t{256} << 20;

struct Header {
  char magic[8] = {'d', 'e', 'r', 'm', 'i', 's', 'p', 'c'};
  std::uint32_t version = 1;
  std::uint32_t vendor = 0, device = 0, driver = 0;
  std::uint8_t uuid[VK_UUID_SIZE]{};
  std::uint64_t bytes = 0;     ///< after this header
  std::uint64_t checksum = 0;  ///< of those bytes
};
static_assert(sizeof(Header) == 56);

/// FNV-1a, 64 bits: finds damage; malice is out of scope for a file in the user's own cache.
std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::byte b : bytes) hash = (hash ^ static_cast<std::uint64_t>(b)) * 0x100000001b3u;
  return hash;
}

Header header_for(const VkPhysicalDeviceProperties& properties, std::span<const std::byte> bytes) {
  Header header;
  header.vendor = properties.vendorID;
  header.device = properties.deviceID;
  header.driver = properties.driverVersion;
  std::memcpy(header.uuid, properties.pipelineCacheUUID, VK_UUID_SIZE);
  header.bytes = bytes.size();
  header.checksum = checksum(bytes);
  return header;
}

}  // namespace

std::vector<std::byte> load_pipeline_cache(const std::filesystem::path& file,
                                           const VkPhysicalDeviceProperties& properties) {
  std::vector<std::byte> all;
  try {
    all = read_file(file, limit_bytes);
  } catch (const InputError&) { return {}; }
  if (all.size() < sizeof(Header)) return {};
  const std::span<const std::byte> bytes = std::span(all).subspan(sizeof(Header));
  const Header expected = header_for(properties, bytes);
  if (std::memcmp(all.data(), &expected, sizeof(Header)) != 0) return {};
  return {bytes.begin(), bytes.end()};
}

void save_pipeline_cache(const std::filesystem::path& file, const VkPhysicalDeviceProperties& properties,
                         std::span<const std::byte> bytes) {
  const Header header = header_for(properties, bytes);
  std::vector<std::byte> all(sizeof(Header) + bytes.size());
  std::memcpy(all.data(), &header, sizeof(Header));
  if (!bytes.empty()) std::memcpy(all.data() + sizeof(Header), bytes.data(), bytes.size());
  try {
    if (file.has_parent_path()) {
      std::error_code failed;
      // if it failed, the write says what is wrong
      std::filesystem::create_directories(file.parent_path(), failed);
    }
    write_file(file, all);
  } catch (const InputError& e) { warn("pipeline cache not kept: {}", e.what()); }
}

}  // namespace dermis::gpu
