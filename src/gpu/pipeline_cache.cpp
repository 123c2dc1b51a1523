// SPDX-License-Identifier: MIT
#include "gpu/pipeline_cache.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include "base/core/cache.h"

namespace dermis::gpu {
namespace {

constexpr std::uint64_t limit_bytes = std::uint64_t{256} << 20;

struct Header {
  char magic[8] = {'d', 'e', 'r', 'm', 'i', 's', 'p', 'c'};
  std::uint32_t version = 2;
  std::uint32_t vendor = 0, device = 0, driver = 0;
  std::uint8_t uuid[VK_UUID_SIZE]{};
  std::uint64_t bytes = 0;  ///< after this header
};
static_assert(sizeof(Header) == 48);

Header header_for(const VkPhysicalDeviceProperties& properties, std::span<const std::byte> bytes) {
  Header header;
  header.vendor = properties.vendorID;
  header.device = properties.deviceID;
  header.driver = properties.driverVersion;
  std::memcpy(header.uuid, properties.pipelineCacheUUID, VK_UUID_SIZE);
  header.bytes = bytes.size();
  return header;
}

}  // namespace

std::vector<std::byte> load_pipeline_cache(const std::filesystem::path& file,
                                           const VkPhysicalDeviceProperties& properties) {
  const std::optional<std::vector<std::byte>> all = cache::read(file, limit_bytes);
  if (!all || all->size() < sizeof(Header)) return {};
  const std::span<const std::byte> bytes = std::span(*all).subspan(sizeof(Header));
  const Header expected = header_for(properties, bytes);
  if (std::memcmp(all->data(), &expected, sizeof(Header)) != 0) return {};
  return {bytes.begin(), bytes.end()};
}

bool save_pipeline_cache(const std::filesystem::path& file, const VkPhysicalDeviceProperties& properties,
                         std::span<const std::byte> bytes) {
  const Header header = header_for(properties, bytes);
  std::vector<std::byte> all(sizeof(Header) + bytes.size());
  std::memcpy(all.data(), &header, sizeof(Header));
  if (!bytes.empty()) std::memcpy(all.data() + sizeof(Header), bytes.data(), bytes.size());
  return cache::write(file, std::move(all));
}

}  // namespace dermis::gpu
