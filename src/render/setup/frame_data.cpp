// SPDX-License-Identifier: MIT
#include "render/setup/frame_data.h"

#include <cstdint>
#include <span>
#include <utility>

#include "base/core/assert.h"
#include "gpu/formats.h"
#include "render/shared/scene_io.h"
#include "render/techniques/mapped_terms.h"

namespace dermis::setup {
namespace {

int texels(std::uint64_t bytes) { return static_cast<int>(bytes / gpu::texel_bytes(gpu::texel_format)); }

// Layers of the map that heads share number the matrices, too.
io::LampsIo add_lamps(gpu::FrameMemory& memory, const passes::Head& head) {
  const int first_layer = static_cast<int>(head.first_shadow_layer);
  const gpu::BufferBinding lights = memory.add(std::span<const io::LightIo>(head.lights)),
                           matrices = memory.add(std::span<const glm::mat4>(head.shadow_from_world));
  return {.lights = texels(lights.offset),
          .shadow_matrices = texels(matrices.offset) - first_layer * texels(sizeof(glm::mat4))};
}

}  // namespace

passes::FrameData frame_data(gpu::FrameMemory& memory, const FrameSetup& setup,
                             const techniques::FrameOutputs& outputs, const EnvironmentLight* environment) {
  passes::FrameData data;
  data.camera = setup.frame.camera;
  data.frame_io = memory.add(std::span<const io::FrameIo>(&setup.frame, 1));
  data.lamps = memory.texels();
  if (environment) data.environment = &environment->map;
  if (environment && environment->picture) data.environment_picture = &environment->picture;

  data.heads = setup.heads;
  for (std::size_t i = 0; i < data.heads.size(); ++i) {
    passes::Head& head = data.heads[i];
    const io::HeadIo io{.world_from_asset = passes::similarity_io(head.world_from_asset),
                        .lamps = add_lamps(memory, head)};
    head.io = memory.add(std::span<const io::HeadIo>(&io, 1));
    if (head.drawn) data.with_heads = joined(data.with_heads, moved(head.area, setup.frame.picture_low));

    const techniques::Model& model = setup.plan.models[head.model];
    head.first_mesh = model.first_mesh;
    if (outputs.map_places.empty()) continue;
    head.map_places = outputs.map_places[i];
    for (const passes::MapPlace& place : head.map_places)
      DERMIS_ASSERT_LE(head.detail.side, place.square_side);
    head.mapped_terms = techniques::mapped_terms_of(setup.plan, model, head.detail);
  }
  return data;
}

}  // namespace dermis::setup
