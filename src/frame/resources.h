// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/assert.h"
#include "frame/graph.h"
#include "gpu/cmd.h"
#include "gpu/resources.h"

namespace dermis::frame {

/// What a recording pass looks its handles up in.
class Resources {
 public:
  const gpu::Texture& texture(TextureId id) const { return at(textures_, id.index); }
  const gpu::Buffer& buffer(BufferId id) const { return at(buffers_, id.index); }
  /// The texture in the layout that sampling passes see it in.
  gpu::SampledBinding sampled(TextureId id, VkSampler sampler) const { return {&texture(id), sampler}; }

 private:
  template <class T>
  static const T& at(const std::vector<T>& all, std::uint32_t index) {
    DERMIS_ASSERT_LT(index, all.size());
    return all[index];
  }
  friend class GraphExecutor;
  std::vector<gpu::Texture> textures_;
  std::vector<gpu::Buffer> buffers_;
};

}  // namespace dermis::frame
