// SPDX-License-Identifier: MIT
/// Computes the light of the entries of one skin mesh of one head: see skin_shading.h and
/// render/passes/pixels/entries/entries.h. An entry that has a part of its pixel is shaded once, on the
/// triangle that most of its samples show: at the middle of these samples, or near it. One that has all of it
/// is shaded at two points, and has their mean. Based on: [DLE07] sec. 3.4 and GPU Gems 3, ch. 14.4.6
#pragma once

#include "render/passes/pixels/entry_buffers.h"
#include "render/passes/pixels/shade/skin_shading.h"

namespace dermis::passes {

class Shade {
 public:
  struct Settings {
    SkinLook look;
    std::uint32_t first_part = 0;  ///< of the mesh, as for Ids
  } settings;
  struct In {
    SkinLights lights;
    EntryBuffers entries;  ///< of EntryList
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  SkinShading shading_;
  const gpu::Pipeline* pipelines_[SkinVariant::count] = {};
};

}  // namespace dermis::passes
