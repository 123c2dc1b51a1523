// SPDX-License-Identifier: MIT
#include "render/passes/clear_buffers.h"

#include "frame/resources.h"

namespace dermis::passes {

ClearBuffers::Out ClearBuffers::declare(frame::Declare& d) {
  d.kind(frame::PassKind::copy);
  d.runs(settings.runs);
  for (const frame::BufferId buffer : in.buffers) d.copy_to(buffer);
  return {};
}

void ClearBuffers::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  for (const frame::BufferId buffer : in.buffers) cmd.fill(resources.buffer(buffer), 0);
}

}  // namespace dermis::passes
