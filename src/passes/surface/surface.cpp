// SPDX-License-Identifier: MIT
#include "passes/surface/surface.h"

#include <algorithm>

#include "frame/resources.h"
#include "passes/surface/surface_io.h"
#include "passes/targets.h"

namespace dermis::passes {

Surface::Out Surface::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.sample(in.shadow);
  d.colour(in.colour);
  d.depth(in.depth);
  return {in.colour, in.depth};
}

void Surface::prepare(gpu::PipelineLibrary& library) {
  gpu::GraphicsDesc desc{.vertex = "surface.vert",
                         .fragment = "surface.frag",
                         .constants = {{"environment", settings.environment ? 1u : 0u},
                                       {"soft_shadows", settings.soft_shadows ? 1u : 0u}},
                         .colour_formats = {light_format},
                         .depth_format = depth_format,
                         .samples = settings.samples,
                         .blend = settings.blended ? gpu::Blend::over : gpu::Blend::none,
                         .cull = gpu::Cull::back,
                         .depth_test = true,
                         .depth_write = !settings.blended};
  single_sided_ = &library.graphics(desc);
  desc.cull = gpu::Cull::none;
  double_sided_ = &library.graphics(desc);
  samplers_ = LightingSamplers(library);
}

void Surface::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const Instance& instance = frame.instances[settings.instance];
  if (!instance.visible && !settings.clear) return;
  begin_picture(cmd, resources.texture(in.colour), resources.texture(in.depth), settings.clear);

  if (instance.visible && settings.blended) draw_blended(cmd, resources, frame, instance);
  if (instance.visible && !settings.blended) draw_groups(cmd, resources, frame, instance);
  cmd.end_rendering();
}

void Surface::bind(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                   const Instance& instance, std::uint32_t page, int material_number) const {
  const GpuMaterial& material = frame.scene->material(material_number);
  const gpu::Pipeline& pipeline = material.double_sided ? *double_sided_ : *single_sided_;
  Bindings bindings;
  bindings.add("Frame", frame.frame_io);
  frame.scene->surfaces.offer(bindings, page);
  material.offer(bindings);
  samplers_.offer(bindings, frame, instance, resources.texture(in.shadow));
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
    return glm::distance(part->centre_m + instance.offset_m, frame.camera.eye_m);
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
