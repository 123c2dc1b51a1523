// SPDX-License-Identifier: MIT
/// As Shade, for techniques in screen space: what of the light is blurred there, and what is known of the
/// surface, goes to images; the entries keep the rest. AddScattered adds what leaves.
#pragma once

#include <array>

#include "render/passes/pixels/entry_buffers.h"
#include "render/passes/pixels/shade/skin_shading.h"
#include "render/passes/screen/screen_surface.h"

namespace dermis::passes {

class ShadeSplit {
 public:
  struct Settings {
    SkinLook look;                          ///< without terms
    std::array<float, 3> blurred{1, 1, 1};  ///< share of the light that is blurred
    double mm_per_unit = 1000;              ///< mm of the asset per metre of the world
    std::uint32_t first_part = 0;           ///< of the mesh, as for Ids
    std::uint32_t first_part_of_head = 0, end_part_of_head = 0;
  } settings;
  struct In {
    SkinLights lights;
    EntryBuffers entries;  ///< of EntryList
    ScreenSurface surface;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  SkinShading shading_;
  gpu::Buffer split_;
  const gpu::Pipeline* pipelines_[SkinVariant::count] = {};
};

}  // namespace dermis::passes
