// SPDX-License-Identifier: MIT
/// Draws the depth of heads into an image of a host: its depth pre-pass, or a shadow map of its own. No part
/// of a plan: a host records it where it likes, with pose and matrix as push constants. Positions are
/// computed as the picture computes them, so a pre-pass has its depth to the bit.
#pragma once

#include <span>

#include "gpu/pipelines.h"
#include "render/passes/head.h"

namespace dermis::passes {

/// The images that it can draw into.
struct HostDepthFormat {
  VkFormat format = VK_FORMAT_D32_SFLOAT;
  std::uint32_t samples = 1;
  bool reversed = true;  ///< near is 1
};

/// An image, ready to be drawn to, and how it is looked at.
struct HostDepthTarget {
  const gpu::Texture* depth = nullptr;
  VkRect2D area{};
  glm::mat4 clip_from_world{1};
  bool y_down = true;
  bool cull = false;  ///< leaves out back faces, as the picture does
};

class HostDepth {
 public:
  HostDepth(gpu::PipelineLibrary& library, const HostDepthFormat& format);

  /// Draws all heads: what is visible is known of another camera. Needs neither their lights nor their maps.
  void record(gpu::Cmd& cmd, const HostDepthTarget& target, std::span<const Head> heads) const;

 private:
  const gpu::Pipeline& pipeline_of(const GpuMaterial& material, bool cull) const {
    return *pipelines_[material.alpha_mode == AssetAlpha::mask][cull && !material.double_sided];
  }
  void draw_skin(gpu::Cmd& cmd, const Head& head, const HostDepthTarget& target) const;
  void draw_surfaces(gpu::Cmd& cmd, const Head& head, const HostDepthTarget& target) const;
  const gpu::Pipeline* pipelines_[2][2] = {};  // [cut out][culled]
};

}  // namespace dermis::passes
