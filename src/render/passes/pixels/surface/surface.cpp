// SPDX-License-Identifier: MIT
#include "render/passes/pixels/surface/surface.h"

#include <algorithm>

#include "frame/resources.h"
#include "render/passes/asset/posed.h"
#include "render/passes/targets.h"

namespace dermis::passes {
namespace {

// Whole instances, so that their parts do not interleave.
void sort_far_to_near(std::vector<const Instance*>& instances, const FrameData& frame) {
  const auto distance = [&](const Instance* instance) {
    return glm::distance(instance->middle_m, frame.camera.eye_m);
  };
  std::stable_sort(instances.begin(), instances.end(),
                   [&](const Instance* a, const Instance* b) { return distance(a) > distance(b); });
}

}  // namespace

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
                                       {"soft_shadows", settings.soft_shadows ? 1u : 0u},
                                       {"layer", settings.layer ? 1u : 0u}},
                         .colour_formats = {settings.format.colour},
                         .depth_format = settings.format.depth,
                         .samples = settings.samples,
                         .blend = settings.blended ? gpu::Blend::over : gpu::Blend::none,
                         .cull = gpu::Cull::back,
                         .depth_test = true,
                         .depth_write = !settings.blended,
                         .depth_compare = settings.format.nearer()};
  single_sided_ = &library.graphics(desc);
  desc.cull = gpu::Cull::none;
  double_sided_ = &library.graphics(desc);
  samplers_ = LightingSamplers(library);
}

void Surface::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  std::vector<const Instance*> visible;
  for (std::uint32_t i = 0; i < settings.instances; ++i)
    if (const Instance& instance = frame.instances[settings.first_instance + i]; instance.is_drawn())
      visible.push_back(&instance);
  if (visible.empty() && !settings.clear) return;

  if (settings.layer)
    begin_layer(cmd, resources.texture(in.colour), resources.texture(in.depth), settings.clear);
  else
    begin_picture(cmd, resources.texture(in.colour), resources.texture(in.depth), settings.clear, frame.area);
  if (settings.blended) sort_far_to_near(visible, frame);
  for (const Instance* instance : visible)
    if (settings.blended)
      draw_blended(cmd, resources, frame, *instance);
    else
      draw_groups(cmd, resources, frame, *instance);
  cmd.end_rendering();
}

void Surface::bind(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                   const Instance& instance, std::uint32_t page, int number) const {
  const GpuMaterial& material = instance.look->material(number);
  const gpu::Pipeline& pipeline = material.double_sided ? *double_sided_ : *single_sided_;
  Bindings bindings;
  bindings.add("Frame", frame.frame_io).add("Head", instance.io);
  offer_page(instance, page, bindings);
  material.offer(bindings);
  samplers_.offer(bindings, frame, instance, resources.texture(in.shadow));
  bindings.bind(cmd, pipeline);
}

void Surface::draw_groups(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                          const Instance& instance) const {
  const GpuSurfaces& surfaces = instance.asset->surfaces;
  for (const GpuSurfaces::Group& group : surfaces.groups) {
    bind(cmd, resources, frame, instance, group.page, group.material);
    for (const GpuSurfaces::Draw& draw : group.draws) surfaces.record(cmd, group.page, draw);
  }
}

void Surface::draw_blended(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                           const Instance& instance) const {
  std::vector<const GpuSurfaces::Blended*> parts;
  for (const GpuSurfaces::Blended& part : instance.asset->surfaces.blended) parts.push_back(&part);
  const auto distance = [&](const GpuSurfaces::Blended* part) {
    return glm::distance(instance.world_from_asset * glm::vec4(part->centre_m, 1), frame.camera.eye_m);
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
    instance.asset->surfaces.record(cmd, part->page, part->draw);
  }
}

}  // namespace dermis::passes
