// SPDX-License-Identifier: MIT
// Inputs of shaders/cull.glsl from the frame.
#pragma once

#include <algorithm>

#include "passes/frame_data.h"
#include "shared/cull_io.h"

namespace dermis::passes {

inline io::CullIo cull_io(const FrameData& frame, const Instance& instance, const GpuMaterial& material) {
  io::CullIo io{.offset_m = instance.offset_m,
                .can_cull = material.double_sided ? 0u : 1u,
                .eye = frame.eye,
                .planes = {},
                .map_side = static_cast<float>(instance.map_side)};
  std::copy(frame.clip_planes.begin(), frame.clip_planes.end(), io.planes);
  return io;
}

}  // namespace dermis::passes
