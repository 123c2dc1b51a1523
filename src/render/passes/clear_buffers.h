// SPDX-License-Identifier: MIT
/// Fills buffers with zeros: counters, and lists that other passes of the frame add to.
#pragma once

#include <vector>

#include "frame/graph.h"
#include "gpu/cmd.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

class ClearBuffers {
 public:
  struct Settings {
    frame::Runs runs = frame::Runs::every_frame;
  } settings;
  struct In {
    std::vector<frame::BufferId> buffers;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
