// SPDX-License-Identifier: MIT
#include "render/techniques/memory.h"

#include "gpu/formats.h"

namespace dermis::techniques {

MapMemory map_memory(const Technique& technique, FrameSettings settings) {
  settings.heads.resize(1);
  settings.heads_per_batch = 1;
  settings.meshes_per_batch = 1;
  passes::FramePlan plan;
  const FrameOutputs outputs = technique.maps(plan, settings);

  const auto sum = [&](const std::vector<frame::TextureId>& maps) {
    std::uint64_t bytes = 0;
    for (const frame::TextureId map : maps) bytes += gpu::bytes_of(plan.textures()[map.index].desc);
    return bytes;
  };
  return {.light_maps = sum(outputs.light_maps), .shadow_maps = sum(outputs.shadow_maps)};
}

}  // namespace dermis::techniques
