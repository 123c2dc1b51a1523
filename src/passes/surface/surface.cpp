// SPDX-License-Identifier: MIT
#include "passes/surface/surface.h"

#include <algorithm>

#include "frame/resources.h"
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

void Surface::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Texture& colour = resources.texture(in_.colour);
  const Instance& instance = frame.instances[settings_.instance];
  if (!instance.visible && !settings_.clear) return;
  gpu::ColourTarget colour_target{.texture = &colour};
  gpu::DepthTarget depth_target{.texture = &resources.texture(in_.depth)};
  if (settings_.clear) colour_target.clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}, depth_target.clear = 0.0f;
  cmd.begin_rendering(std::span(&colour_target, 1), depth_target,
                      {colour.desc().width, colour.desc().height});

  if (instance.visible && settings_.blended) draw_blended(cmd, resources, frame, instance);
  if (instance.visible && !settings_.blended) draw_groups(cmd, resources, frame, instance);
  cmd.end_rendering();
}

void Surface::bind(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                   const Instance& instance, std::uint32_t page, int material_number) const {
  const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(material_number)];
  const gpu::Pipeline& pipeline = material.double_sided ? *double_sided_ : *single_sided_;
  Bindings bindings;
  frame.scene->surfaces.offer(bindings, page);
  material.offer(bindings);
  samplers_.offer(bindings, frame, instance, resources.texture(in_.shadow));
  bindings.bind(cmd, pipeline);
  cmd.push(pipeline, io::SurfaceIo{.offset_m = instance.offset_m});
}

void Surface::draw_groups(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                          const Instance& instance) const {
  for (const GpuSurfaces::Group& group : frame.scene->surfaces.groups) {
    bind(cmd, resources, frame, instance, group.page, group.material);
    for (const GpuSurfaces::Draw& draw : group.draws)
      cmd.draw(draw.index_count, draw.placements, draw.first_index, draw.first_placement);
  }
}

void Surface::draw_blended(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                           const Instance& instance) const {
  std::vector<const GpuSurfaces::Blended*> parts;
  for (const GpuSurfaces::Blended& part : frame.scene->surfaces.blended) parts.push_back(&part);
  const auto distance = [&](const GpuSurfaces::Blended* part) {
    return glm::distance(part->centre_m + instance.offset_m, frame.eye_m);
  };
  std::stable_sort(parts.begin(), parts.end(),
                   [&](const GpuSurfaces::Blended* a, const GpuSurfaces::Blended* b) {
                     return distance(a) > distance(b);
                   });

  const GpuSurfaces::Blended* bound = nullptr;
  for (const GpuSurfaces::Blended* part : parts) {
    if (!bound || bound->page != part->page || bound->material != part->material)
      bind(cmd, resources, frame, instance, part->page, part->material);
    bound = part;
    cmd.draw(part->draw.index_count, 1, part->draw.first_index, part->draw.first_placement);
  }
}

}  // namespace dermis::passes
