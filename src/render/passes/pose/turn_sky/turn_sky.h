// SPDX-License-Identifier: MIT
/// Finds the light of the sky on skin that has moved: what each point saw of the sky as its asset was loaded
/// turns with it, and the sky stays. Occluders that the pose moves are not found anew. Based on: [SKS02]
/// Sloan, Kautz, Snyder: Precomputed Radiance Transfer. SIGGRAPH 2002 (sec. 5: rigid motion of objects turns
/// the light into their coordinates; here each point has its own)
#pragma once

#include "frame/graph.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

class TurnSky {
 public:
  struct Settings {
  } settings;
  struct In {
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  /// Records nothing if FrameData::sky_turns is empty. After MoveRig: reads the vertices that it has moved.
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void record_turns(gpu::Cmd& cmd, const SkyTurn& turn) const;
  void record_light(gpu::Cmd& cmd, const SkyTurn& turn) const;

  const gpu::Pipeline* turns_ = nullptr;
  const gpu::Pipeline* light_ = nullptr;
  VkSampler nearest_ = VK_NULL_HANDLE;
};

}  // namespace dermis::passes
