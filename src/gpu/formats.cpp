// SPDX-License-Identifier: MIT
#include "gpu/formats.h"

#include <algorithm>
#include <iterator>

#include "base/core/assert.h"
#include "gpu/resources.h"

namespace dermis::gpu {
namespace {

struct Row {
  VkFormat format;
  std::uint32_t bytes;
  const char* name;
};

#define DERMIS_FORMAT(name, bytes) \
  Row { VK_FORMAT_##name, bytes, #name }
constexpr Row rows[] = {
    DERMIS_FORMAT(R8_UNORM, 1),
    DERMIS_FORMAT(R8_UINT, 1),
    DERMIS_FORMAT(R8G8_UNORM, 2),
    DERMIS_FORMAT(R8G8_SNORM, 2),
    DERMIS_FORMAT(R8G8B8A8_UNORM, 4),
    DERMIS_FORMAT(R8G8B8A8_SNORM, 4),
    DERMIS_FORMAT(R8G8B8A8_SRGB, 4),
    DERMIS_FORMAT(R8G8B8A8_UINT, 4),
    DERMIS_FORMAT(B8G8R8A8_UNORM, 4),
    DERMIS_FORMAT(B8G8R8A8_SRGB, 4),
    DERMIS_FORMAT(A2B10G10R10_UNORM_PACK32, 4),
    DERMIS_FORMAT(B10G11R11_UFLOAT_PACK32, 4),
    DERMIS_FORMAT(R16_UNORM, 2),
    DERMIS_FORMAT(R16_UINT, 2),
    DERMIS_FORMAT(R16_SFLOAT, 2),
    DERMIS_FORMAT(R16G16_UNORM, 4),
    DERMIS_FORMAT(R16G16_SFLOAT, 4),
    DERMIS_FORMAT(R16G16B16A16_UNORM, 8),
    DERMIS_FORMAT(R16G16B16A16_SFLOAT, 8),
    DERMIS_FORMAT(R32_UINT, 4),
    DERMIS_FORMAT(R32_SINT, 4),
    DERMIS_FORMAT(R32_SFLOAT, 4),
    DERMIS_FORMAT(R32G32_UINT, 8),
    DERMIS_FORMAT(R32G32_SFLOAT, 8),
    DERMIS_FORMAT(R32G32B32A32_UINT, 16),
    DERMIS_FORMAT(R32G32B32A32_SFLOAT, 16),
    DERMIS_FORMAT(D16_UNORM, 2),
    DERMIS_FORMAT(D32_SFLOAT, 4),
};
#undef DERMIS_FORMAT

const Row* find(VkFormat format) {
  const Row* row = std::ranges::find(rows, format, &Row::format);
  return row == std::end(rows) ? nullptr : row;
}

}  // namespace

std::uint32_t texel_bytes(VkFormat format) {
  const Row* row = find(format);
  if (row == nullptr)
    assertion_failed("format is in the list of gpu/formats.cpp", fmt::format("{}", static_cast<int>(format)),
                     __FILE__, __LINE__);
  return row->bytes;
}

const char* format_name(VkFormat format) {
  const Row* row = find(format);
  return row ? row->name : "unknown format";
}

VkImageAspectFlags aspect_of(VkFormat format) {
  return format == VK_FORMAT_D32_SFLOAT || format == VK_FORMAT_D16_UNORM ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                                         : VK_IMAGE_ASPECT_COLOR_BIT;
}

std::uint64_t texels_of(const TextureDesc& desc) {
  std::uint64_t texels = 0;
  for (std::uint32_t mip = 0; mip < desc.mips; ++mip)
    texels += std::uint64_t{std::max(1u, desc.width >> mip)} * std::max(1u, desc.height >> mip);
  return texels * desc.layers;
}

std::uint64_t bytes_of(const TextureDesc& desc) {
  return texels_of(desc) * desc.samples * texel_bytes(desc.format);
}

}  // namespace dermis::gpu
