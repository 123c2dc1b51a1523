// SPDX-License-Identifier: MIT
#include "passes/shadow/shadow.h"

#include "frame/executor.h"
#include "passes/shadow/shadow_io.h"

namespace dermis::passes {
namespace {

void draw_meshes(gpu::Cmd& cmd, const std::vector<GpuMesh>& meshes, const GpuScene& scene, const gpu::Pipeline& pipeline, bool cut_out,
                 const io::ShadowIo& io) {
  for (const GpuMesh& mesh : meshes)
    for (const GpuDraw& draw : mesh.draws) {
      const GpuMaterial& material = scene.materials[static_cast<std::size_t>(draw.material)];
      // Blended parts (lashes, brows) would cast the shadow of their whole card.
      if (material.alpha_mode == scene::AlphaMode::blend || (material.alpha_mode == scene::AlphaMode::mask) != cut_out) continue;
      Bindings bindings;
      mesh.offer(bindings);
      material.offer(bindings);
      bindings.bind(cmd, pipeline);
      cmd.push(pipeline, io);
      cmd.draw(draw.index_count, 1, draw.first_index);
    }
}

}  // namespace

Shadow::Out Shadow::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  in_ = in;
  d.depth(in.shadow);
  return {in.shadow};
}

void Shadow::prepare(gpu::PipelineLibrary& library) {
  gpu::GraphicsDesc desc{.vertex = "shadow.vert", .depth_format = VK_FORMAT_D32_SFLOAT, .depth_test = true, .depth_write = true};
  solid_ = &library.graphics(desc);
  desc.fragment = "shadow.frag";
  cut_out_ = &library.graphics(desc);
}

void Shadow::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const {
  const gpu::Texture& shadow = resources.texture(in_.shadow);
  const frame::Instance& instance = frame.instances[settings_.instance];
  if (!instance.visible) return;
  for (std::uint32_t layer = 0; layer < settings_.layers; ++layer) {
    cmd.begin_rendering({}, gpu::DepthTarget{.texture = &shadow, .layer = instance.first_shadow_layer + layer, .clear = 0.0f},
                        {shadow.desc().width, shadow.desc().height}, true);
    if (layer < instance.shadow_from_world.size()) {
      const io::ShadowIo io{.shadow_from_world = instance.shadow_from_world[layer], .offset_m = instance.offset_m};
      for (const auto* meshes : {&frame.scene->skin, &frame.scene->surfaces}) {
        draw_meshes(cmd, *meshes, *frame.scene, *solid_, false, io);
        draw_meshes(cmd, *meshes, *frame.scene, *cut_out_, true, io);
      }
    }
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
