// SPDX-License-Identifier: MIT
/// Depth of heads as each light sees them: one layer per head and light, six for a point light inside the
/// scene. Reversed depth, 0 where there is nothing. Also stores the light that enters there, for translucent
/// shadow maps.
/// Based on: [SD03] Dachsbacher, Stamminger: Translucent Shadow Maps, 2003
#pragma once

#include "frame/graph.h"
#include "render/passes/frame_data.h"
#include "render/passes/shadow/shadow_io.h"

namespace dermis::passes {

inline constexpr VkFormat entering_format = VK_FORMAT_R8G8B8A8_UNORM;
/// For maps where the mix of all skin is 0: all light enters, if it meets the front. Read as (R, R, R, G).
inline constexpr VkFormat facing_format = VK_FORMAT_R8G8_UNORM;

class Shadow {
 public:
  struct Settings {
    std::uint32_t first_head = 0, heads = 1;
    std::uint32_t layers = 1;  ///< of one head
    /// Entering light is drawn separately, smaller than the depth map: geometry is enlarged by a texel along
    /// its normals, so that each point of the depth map finds an entry.
    bool grown = false;
    bool host_maps = false;  ///< some layers come from a host: Head::host_shadows
  } settings;
  struct In {
    /// D32, square; layers of a head begin at Head::first_shadow_layer, and its maps lie in their corner.
    frame::TextureId shadow;
    /// entering_format or facing_format, the same size and layers: square root of the part that enters
    /// (albedo^mix of the front of skin, 0 elsewhere), alpha 1 where there is something.
    frame::TextureId entering = {};  ///< not valid: not stored
  } in;
  struct Out {
    frame::TextureId shadow;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  static bool casts(const GpuMaterial& material, bool cut_out);
  void draw_layer(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame, const Head& head,
                  std::uint32_t layer) const;
  void take_host_map(gpu::Cmd& cmd, const HostShadowMap& map, const gpu::Texture& shadow) const;
  void draw_skin(gpu::Cmd& cmd, const FrameData& frame, const Head& head, bool cut_out,
                 const io::ShadowIo& io) const;
  void draw_surfaces(gpu::Cmd& cmd, const FrameData& frame, const Head& head, bool cut_out,
                     const io::ShadowIo& io) const;
  const gpu::Pipeline* pipelines_[2][2][2] = {};  // [skin][cut out][mixed]
  const gpu::Pipeline* host_map_ = nullptr;
  VkSampler nearest_ = VK_NULL_HANDLE;
  VkFormat stored_ = VK_FORMAT_UNDEFINED;  // of what enters
};

}  // namespace dermis::passes
