// SPDX-License-Identifier: MIT
#include "render/passes/pixels/surface/surface.h"

#include <algorithm>

#include "frame/resources.h"
#include "render/passes/asset/offer.h"
#include "render/passes/targets.h"

namespace dermis::passes {
namespace {

// Whole heads, so that their parts do not interleave.
void sort_far_to_near(std::vector<const Head*>& heads, const FrameData& frame) {
  const auto distance = [&](const Head* head) { return glm::distance(head->middle_m, frame.camera.eye_m); };
  std::stable_sort(heads.begin(), heads.end(),
                   [&](const Head* a, const Head* b) { return distance(a) > distance(b); });
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
  std::vector<const Head*> visible;
  for (std::uint32_t i = 0; i < settings.heads; ++i)
    if (const Head& head = frame.heads[settings.first_head + i]; head.is_drawn()) visible.push_back(&head);
  if (visible.empty() && !settings.clear) return;

  if (settings.layer)
    begin_layer(cmd, resources.texture(in.colour), resources.texture(in.depth), settings.clear);
  else
    begin_picture(cmd, resources.texture(in.colour), resources.texture(in.depth), settings.clear, frame.area);
  if (settings.blended) sort_far_to_near(visible, frame);
  for (const Head* head : visible)
    if (settings.blended)
      draw_blended(cmd, resources, frame, *head);
    else
      draw_groups(cmd, resources, frame, *head);
  cmd.end_rendering();
}

void Surface::bind(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame, const Head& head,
                   std::uint32_t page, int number) const {
  const GpuMaterial& material = head.look->material(number);
  const gpu::Pipeline& pipeline = material.double_sided ? *double_sided_ : *single_sided_;
  Bindings bindings;
  bindings.add("Frame", frame.frame_io).add("Head", head.io);
  offer_page(head, page, bindings);
  material.offer(bindings);
  samplers_.offer(bindings, frame, head, resources.texture(in.shadow));
  bindings.bind(cmd, pipeline);
}

void Surface::draw_groups(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                          const Head& head) const {
  const GpuSurfaces& surfaces = head.asset->surfaces;
  for (const GpuSurfaces::Group& group : surfaces.groups) {
    bind(cmd, resources, frame, head, group.page, group.material);
    for (const GpuSurfaces::Draw& draw : group.draws) surfaces.record(cmd, group.page, draw);
  }
}

void Surface::draw_blended(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                           const Head& head) const {
  std::vector<const GpuSurfaces::Blended*> parts;
  for (const GpuSurfaces::Blended& part : head.asset->surfaces.blended) parts.push_back(&part);
  const auto distance = [&](const GpuSurfaces::Blended* part) {
    return glm::distance(head.world_from_asset.position(part->centre_m), frame.camera.eye_m);
  };
  std::stable_sort(parts.begin(), parts.end(),
                   [&](const GpuSurfaces::Blended* a, const GpuSurfaces::Blended* b) {
                     return distance(a) > distance(b);
                   });

  const GpuSurfaces::Blended* bound = nullptr;
  for (const GpuSurfaces::Blended* part : parts) {
    if (!bound || bound->page != part->page || bound->material != part->material)
      bind(cmd, resources, frame, head, part->page, part->material);
    bound = part;
    head.asset->surfaces.record(cmd, part->page, part->draw);
  }
}

}  // namespace dermis::passes
