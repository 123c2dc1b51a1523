// SPDX-License-Identifier: MIT
/// Counts the points at which Shade reads a texel of a light map that was never lit, for the statistics.
/// Takes what Shade does, before it.
#pragma once

#include "render/passes/pixels/entry_buffers.h"
#include "render/passes/pixels/shade/skin_shading.h"

namespace dermis::passes {

/// A member of frame::Together.
class UnshadedReads {
 public:
  struct Settings {
    SkinLook look;
    std::uint32_t first_part = 0;  ///< as for Shade
    std::uint32_t slot = 0;        ///< of the counters
  } settings;
  struct In {
    SkinLights lights;
    EntryBuffers entries;  ///< of EntryList
    frame::BufferId counters;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  SkinShading shading_;
  const gpu::Pipeline* pipelines_[SkinVariant::count] = {};  // null: reads no map
};

}  // namespace dermis::passes
