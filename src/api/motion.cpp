// SPDX-License-Identifier: MIT
#include "api/motion.h"

#include <span>

#include "render/passes/pixels/labels/labels_io.h"

namespace dermis::api {

void Motion::fill(gpu::FrameMemory& memory, const setup::PlacedScene& placed,
                  const std::vector<InstanceId>& ids, passes::FrameData& data) {
  before_ = std::move(last_);
  last_ = {.clip_from_world = data.camera.clip_from_world};
  const bool row = data.heads.size() > placed.instances.size();

  for (passes::Head& head : data.heads) {
    const setup::PlacedInstance& now = placed.instances[head.instance];
    const std::pair key(ids[head.instance], row ? head.number : 0u);
    const Stood stands{.asset = now.asset,
                       .world_from_asset = passes::similarity_io(head.world_from_asset),
                       .posed = now.posed};
    last_.heads[key] = stands;

    const auto found = before_.heads.find(key);
    const bool known = found != before_.heads.end() && found->second.asset == now.asset;
    const Stood& stood = known ? found->second : stands;
    const io::LabelsBeforeIo io{.clip_from_world = known ? before_.clip_from_world : last_.clip_from_world,
                                .world_from_asset = stood.world_from_asset,
                                .moved = known && head.posed && head.moves ? 1u : 0u};
    head.before = memory.add(std::span<const io::LabelsBeforeIo>(&io, 1));

    // Without a pose of its own then, it stood as it was loaded.
    if (head.placements.empty() || stood.posed == now.posed) continue;
    for (const passes::GpuSurfaces::Page& page : head.asset->surfaces.pages)
      head.placements_before.push_back(
          stood.posed ? gpu::BufferBinding{memory.add(std::span<const io::PlacementIo>(
                            passes::posed_placements(page, *now.asset, stood.posed->rig)))}
                      : gpu::BufferBinding{&page.placements});
  }
}

}  // namespace dermis::api
