// SPDX-License-Identifier: MIT
/// Writes shaded entries into the targets of a host, sample by sample: the light of the entry that the sample
/// shows, and the depth that was drawn with its id. Things that the host has in front hide it. One invocation
/// per pixel and sample writes that sample alone: sample shading is an optional feature of devices.
#pragma once

#include "render/passes/pixels/entry_buffers.h"
#include "render/passes/targets.h"

namespace dermis::passes {

class ComposeEntries {
 public:
  struct Settings {
    std::uint32_t samples = 1;                ///< of all targets
    PictureFormat format;                     ///< of those of the host
    std::uint32_t first_part = 0, parts = 0;  ///< those that are shaded, see Ids
  } settings;
  struct In {
    EntryBuffers entries;
    frame::TextureId ids, ids_depth;  ///< of Ids
    frame::TextureId colour, depth;   ///< of the host
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
