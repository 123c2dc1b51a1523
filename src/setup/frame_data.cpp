// SPDX-License-Identifier: MIT
#include "setup/frame_data.h"

#include <span>
#include <utility>

#include "techniques/mapped_terms.h"

namespace dermis::setup {

io::InstanceIo instance_io(const Pose& pose) {
  return {.x_axis = pose.rotation[0],
          .y_axis = pose.rotation[1],
          .z_axis = pose.rotation[2],
          .origin_m = pose.origin_m,
          .scale = pose.scale};
}

namespace {

passes::Instance instance_of(gpu::FrameMemory& memory, const HeadSetup& head) {
  passes::Instance instance;
  instance.number = static_cast<std::uint32_t>(head.number);
  instance.world_from_asset = head.pose.matrix();
  instance.middle_m = head.middle_m;
  const io::InstanceIo io = instance_io(head.pose);
  instance.transform = memory.add(std::span<const io::InstanceIo>(&io, 1));
  instance.map_side = static_cast<std::uint32_t>(head.map_side);
  instance.visible = head.visible;
  instance.drawn = head.drawn;
  instance.lights = memory.add(std::span<const io::LightIo>(head.lights));

  // Leave room in front, so that layers of the map that heads share number the matrices, too.
  std::vector<glm::mat4> matrices(head.first_shadow_layer, glm::mat4(0));
  matrices.insert(matrices.end(), head.shadow_from_world.begin(), head.shadow_from_world.end());
  instance.shadow_matrices = memory.add(std::span<const glm::mat4>(matrices));
  instance.first_shadow_layer = head.first_shadow_layer;
  instance.shadow_from_world = head.shadow_from_world;
  instance.host_shadows = head.host_shadows;
  return instance;
}

}  // namespace

passes::FrameData frame_data(gpu::FrameMemory& memory, const FrameSetup& setup,
                             const techniques::FrameOutputs& outputs,
                             std::span<const InstanceOnDevice> instances,
                             const EnvironmentLight* environment) {
  passes::FrameData data;
  data.camera = setup.frame.camera;
  data.frame_io = memory.add(std::span<const io::FrameIo>(&setup.frame, 1));
  if (environment) data.environment = &environment->map;
  if (environment && environment->picture) data.environment_picture = &environment->picture;

  for (const HeadSetup& head : setup.heads) {
    passes::Instance instance = instance_of(memory, head);
    const InstanceOnDevice& on_device = instances[head.instance];
    instance.scene = on_device.scene;
    instance.look = on_device.look;
    instance.sky = on_device.sky;
    instance.first_mesh = setup.plan.models[head.model].first_mesh;
    if (!outputs.map_places.empty()) {
      instance.map_places = outputs.map_places[data.instances.size()];
      instance.mapped_terms =
          techniques::mapped_terms_of(setup.plan, setup.plan.models[head.model], instance.map_side);
    }
    data.instances.push_back(std::move(instance));
  }
  return data;
}

}  // namespace dermis::setup
