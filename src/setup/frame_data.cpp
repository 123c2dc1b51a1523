// SPDX-License-Identifier: MIT
#include "setup/frame_data.h"

#include <span>
#include <utility>

namespace dermis::setup {
namespace {

passes::Instance instance_of(gpu::Device& device, const HeadSetup& head) {
  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  passes::Instance instance;
  instance.offset_m = head.offset_m;
  instance.map_side = static_cast<std::uint32_t>(head.map_side);
  instance.visible = head.visible;
  instance.lights = gpu::make_buffer(device, "lights", std::span<const io::LightIo>(head.lights), storage);

  // Leave room in front, so that layers of the map that heads share number the matrices, too.
  std::vector<glm::mat4> matrices(head.first_shadow_layer, glm::mat4(0));
  matrices.insert(matrices.end(), head.shadow_from_world.begin(), head.shadow_from_world.end());
  instance.shadow_matrices =
      gpu::make_buffer(device, "shadow matrices", std::span<const glm::mat4>(matrices), storage);
  instance.first_shadow_layer = head.first_shadow_layer;
  instance.shadow_from_world = head.shadow_from_world;
  return instance;
}

}  // namespace

gpu::Buffer frame_buffer(gpu::Device& device, const io::FrameIo& frame) {
  return gpu::make_buffer(device, "frame", std::span(&frame, 1), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
}

passes::FrameData frame_data(gpu::Device& device, const FrameSetup& setup,
                             const techniques::FrameOutputs& outputs, const passes::GpuScene& scene,
                             const SkyOnSkin& sky) {
  passes::FrameData data;
  data.scene = &scene;
  data.camera = setup.frame.camera;
  data.frame_io = frame_buffer(device, setup.frame);
  if (sky.of) data.environment = &sky.of->map;
  data.sky = sky.maps;

  for (const HeadSetup& head : setup.heads) {
    passes::Instance instance = instance_of(device, head);
    if (!outputs.map_places.empty()) instance.map_places = outputs.map_places[data.instances.size()];
    data.instances.push_back(std::move(instance));
  }
  return data;
}

}  // namespace dermis::setup
