// SPDX-License-Identifier: MIT
// What changes from frame to frame, as the passes see it when they record.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "frame/plan.h"
#include "gpu/resources.h"
#include "passes/gpu_scene.h"

namespace dermis::frame {

/// One head in the frame: the scene once more, moved. Shadow maps are fitted to each.
struct Instance {
  glm::vec3 offset_m{0};
  gpu::Buffer lights;                        ///< LightIo[]
  gpu::Buffer shadow_matrices;               ///< mat4[], one a layer
  std::vector<glm::mat4> shadow_from_world;  ///< the same, for drawing the layers
};

struct FrameData {
  const passes::GpuScene* scene = nullptr;
  gpu::Buffer frame_io;  ///< FrameIo
  glm::vec3 eye_m{0};
  std::vector<Instance> instances;
};

}  // namespace dermis::frame
