// SPDX-License-Identifier: MIT
#include "passes/surface/surface.h"

#include <algorithm>

#include "frame/executor.h"
#include "passes/surface/surface_io.h"

namespace dermis::passes {

Surface::Out Surface::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  in_ = in;
  d.sample(in.shadow);
  d.colour(in.colour);
  d.depth(in.depth);
  return {in.colour, in.depth};
}

void Surface::prepare(gpu::PipelineLibrary& library) {
  gpu::GraphicsDesc desc{.vertex = "surface.vert",
                         .fragment = "surface.frag",
                         .constants = {{"environment", settings_.environment ? 1u : 0u},
                                       {"soft_shadows", settings_.soft_shadows ? 1u : 0u}},
                         .colour_formats = {VK_FORMAT_R16G16B16A16_SFLOAT},
                         .depth_format = VK_FORMAT_D32_SFLOAT,
                         .samples = settings_.samples,
                         .blend = settings_.blended ? gpu::Blend::over : gpu::Blend::none,
                         .cull = gpu::Cull::back,
                         .depth_test = true,
                         .depth_write = !settings_.blended};
  single_sided_ = &library.graphics(desc);
  desc.cull = gpu::Cull::none;
  double_sided_ = &library.graphics(desc);
  samplers_ = LightingSamplers(library);
}

void Surface::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const {
  const gpu::Texture& colour = resources.texture(in_.colour);
  const frame::Instance& instance = frame.instances[settings_.instance];
  if (!instance.visible && !settings_.clear) return;
  gpu::ColourTarget colour_target{.texture = &colour};
  gpu::DepthTarget depth_target{.texture = &resources.texture(in_.depth)};
  if (settings_.clear) colour_target.clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}, depth_target.clear = 0.0f;
  cmd.begin_rendering(std::span(&colour_target, 1), depth_target,
                      {colour.desc().width, colour.desc().height});

  std::vector<const GpuMesh*> meshes;
  for (const GpuMesh& mesh : frame.scene->surfaces) {
    if (!instance.visible) break;
    const GpuMaterial& material =
        frame.scene->materials[static_cast<std::size_t>(mesh.draws.front().material)];
    if ((material.alpha_mode == scene::AlphaMode::blend) == settings_.blended) meshes.push_back(&mesh);
  }
  if (settings_.blended) {
    const auto distance = [&](const GpuMesh* mesh) {
      return glm::distance(mesh->centre_m + instance.offset_m, frame.eye_m);
    };
    std::stable_sort(meshes.begin(), meshes.end(),
                     [&](const GpuMesh* a, const GpuMesh* b) { return distance(a) > distance(b); });
  }
  for (const GpuMesh* mesh : meshes) {
    const GpuDraw& draw = mesh->draws.front();
    const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(draw.material)];
    const gpu::Pipeline& pipeline = material.double_sided ? *double_sided_ : *single_sided_;
    Bindings bindings;
    mesh->offer(bindings);
    material.offer(bindings);
    samplers_.offer(bindings, frame, instance, resources.texture(in_.shadow));
    bindings.bind(cmd, pipeline);
    cmd.push(pipeline, io::SurfaceIo{.offset_m = instance.offset_m});
    cmd.draw(draw.index_count, 1, draw.first_index);
  }
  cmd.end_rendering();
}

}  // namespace dermis::passes
