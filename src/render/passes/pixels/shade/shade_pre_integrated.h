// SPDX-License-Identifier: MIT
/// As Shade without terms, but with scattering integrated beforehand. The light of each pixel comes from
/// tables, over the curvature of the skin and the distance to the edge of a shadow. Based on: [Pen11] and
/// [FW14] of tissue/gaussians/pre_integrated.h
#pragma once

#include <array>

#include "render/passes/pixels/entry_buffers.h"
#include "render/passes/pixels/shade/skin_shading.h"

namespace dermis::passes {

/// A member of frame::Together.
class ShadePreIntegrated {
 public:
  struct Settings {
    SkinLook look;                            ///< without terms
    ScatterProfile profile;                   ///< in mm of the asset
    std::array<float, 3> scattered{1, 1, 1};  ///< share of the light that scatters
    bool ring = false;                        ///< gaussians::lit_ring() in place of lit_arc()
    std::uint32_t shadow_taps = 32;           ///< of the filter of shadows
    double mm_per_unit = 1000;                ///< mm of the asset per metre of the world
    std::uint32_t first_part = 0;             ///< as for Ids
  } settings;
  struct In {
    SkinLights lights;
    EntryBuffers entries;       ///< of EntryList
    frame::BufferId curvature;  ///< of render/passes/pose/curvature
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  SkinShading shading_;
  gpu::Buffer scatter_;
  gpu::Texture lit_, edge_;
  VkSampler sampler_ = VK_NULL_HANDLE;
  const gpu::Pipeline* pipelines_[SkinVariant::count] = {};
};

}  // namespace dermis::passes
