// SPDX-License-Identifier: MIT
#include "render/setup/frame_data.h"

#include <cstdint>
#include <span>
#include <utility>

#include "gpu/formats.h"
#include "render/shared/scene_io.h"
#include "render/techniques/mapped_terms.h"

namespace dermis::setup {

io::InstanceIo instance_io(const Similarity& world_from_asset) {
  return {.x_axis = world_from_asset.rotation[0],
          .y_axis = world_from_asset.rotation[1],
          .z_axis = world_from_asset.rotation[2],
          .origin_m = world_from_asset.origin_m,
          .scale = world_from_asset.scale};
}

namespace {

int texels(std::uint64_t bytes) { return static_cast<int>(bytes / gpu::texel_bytes(gpu::texel_format)); }

// Layers of the map that heads share number the matrices, too.
io::LampsIo add_lamps(gpu::FrameMemory& memory, const Head& head) {
  const int first_layer = static_cast<int>(head.first_shadow_layer);
  const gpu::BufferBinding lights = memory.add(std::span<const io::LightIo>(head.lights)),
                           matrices = memory.add(std::span<const glm::mat4>(head.shadow_from_world));
  return {.lights = texels(lights.offset),
          .shadow_matrices = texels(matrices.offset) - first_layer * texels(sizeof(glm::mat4))};
}

void place(passes::Instance& instance, gpu::FrameMemory& memory, const Head& head) {
  instance.number = static_cast<std::uint32_t>(head.number);
  instance.world_from_asset = head.world_from_asset.matrix();
  instance.middle_m = head.middle_m;
  const io::HeadIo io{.instance = instance_io(head.world_from_asset), .lamps = add_lamps(memory, head)};
  instance.io = memory.add(std::span<const io::HeadIo>(&io, 1));
  instance.map_side = head.detail.side;
  instance.visible = head.visible;
  instance.drawn = head.drawn;
  instance.first_shadow_layer = head.first_shadow_layer;
  instance.shadow_from_world = head.shadow_from_world;
  instance.shadow_side = head.shadow_side;
  instance.host_shadows = head.host_shadows;
}

}  // namespace

passes::FrameData frame_data(gpu::FrameMemory& memory, const FrameSetup& setup,
                             const techniques::FrameOutputs& outputs,
                             std::span<const passes::Instance> instances,
                             const EnvironmentLight* environment) {
  passes::FrameData data;
  data.camera = setup.frame.camera;
  data.frame_io = memory.add(std::span<const io::FrameIo>(&setup.frame, 1));
  data.lamps = memory.texels();
  if (environment) data.environment = &environment->map;
  if (environment && environment->picture) data.environment_picture = &environment->picture;

  for (const Head& head : setup.heads) {
    if (head.drawn) data.heads = joined(data.heads, moved(head.area, setup.frame.picture_low));
    passes::Instance& instance = data.instances.emplace_back(instances[head.instance]);
    place(instance, memory, head);
    instance.first_mesh = setup.plan.models[head.model].first_mesh;
    if (!outputs.map_places.empty()) {
      instance.map_places = outputs.map_places[data.instances.size() - 1];
      instance.mapped_terms =
          techniques::mapped_terms_of(setup.plan, setup.plan.models[head.model], head.detail);
    }
  }
  return data;
}

}  // namespace dermis::setup
