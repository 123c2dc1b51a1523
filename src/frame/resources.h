// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "base/core/assert.h"
#include "frame/graph.h"
#include "gpu/cmd.h"
#include "gpu/resources.h"

namespace dermis::frame {

/// Maps handles to resources while a pass records.
class Resources {
 public:
  const gpu::Texture& texture(TextureId id) const { return at(textures_, id.index); }
  const gpu::Buffer& buffer(BufferId id) const { return at(buffers_, id.index); }
  /// Returns the texture in the layout of sampling passes, read at its nearest texel or between texels.
  gpu::SampledBinding nearest(TextureId id) const {
    return {&texture(id), nearest_, at(sampled_layouts_, id.index)};
  }
  gpu::SampledBinding linear(TextureId id) const {
    return {&texture(id), linear_, at(sampled_layouts_, id.index)};
  }
  gpu::SampledBinding linear(const gpu::Texture& texture) const { return {&texture, linear_}; }
  gpu::StorageImageBinding storage(TextureId id) const { return {&texture(id)}; }

 private:
  template <class T>
  static const T& at(const std::vector<T>& all, std::uint32_t index) {
    DERMIS_ASSERT_LT(index, all.size());
    return all[index];
  }
  friend class GraphExecutor;
  std::vector<gpu::Texture> textures_;
  std::vector<gpu::Buffer> buffers_;
  std::vector<VkImageLayout> sampled_layouts_;  // by texture
  VkSampler nearest_ = VK_NULL_HANDLE, linear_ = VK_NULL_HANDLE;
};

}  // namespace dermis::frame
