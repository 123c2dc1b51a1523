// SPDX-License-Identifier: MIT
// Inputs of render/shaders/cull.glsl, beside the frame's camera.
#pragma once

#include "render/passes/frame_data.h"
#include "render/shared/cull_io.h"

namespace dermis::passes {

inline io::CullIo cull_io(const Instance& instance, const GpuMaterial& material) {
  return {.can_cull = material.double_sided ? 0u : 1u, .map_side = static_cast<float>(instance.map_side)};
}

}  // namespace dermis::passes
