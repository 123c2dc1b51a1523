// SPDX-License-Identifier: MIT
#include "render/passes/pixels/labels/front_layer.h"

#include <span>

#include "frame/resources.h"
#include "render/passes/pixels/labels/labels.h"
#include "render/passes/targets.h"

namespace dermis::passes {
namespace {

constexpr VkFormat coverage_format = VK_FORMAT_R16_SFLOAT, part_format = VK_FORMAT_R32_UINT;

}  // namespace

FrontLayer::Out FrontLayer::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  out_.layer = d.create(shows_part() ? "front parts" : "front coverage",
                        gpu::TextureDesc{.width = settings.width,
                                         .height = settings.height,
                                         .format = shows_part() ? part_format : coverage_format});
  d.colour(out_.layer);
  d.depth(in.depth);
  return out_;
}

void FrontLayer::prepare(gpu::PipelineLibrary& library) {
  for (const bool double_sided : {false, true})
    pipelines_[double_sided] =
        &library.graphics({.vertex = "labels.vert",
                           .fragment = shows_part() ? "front_part.frag" : "front_coverage.frag",
                           .constants = {{"skin", 0u}, {"body", shows_part() ? 1u : 0u}},
                           .colour_formats = {shows_part() ? part_format : coverage_format},
                           .depth_format = depth_format,
                           .blend = shows_part() ? gpu::Blend::none : gpu::Blend::over,
                           .cull = double_sided ? gpu::Cull::none : gpu::Cull::back,
                           .depth_test = true,
                           .depth_write = shows_part()});
}

void FrontLayer::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::ColourTarget layer{.texture = &resources.texture(out_.layer), .clear = no_light};
  const gpu::DepthTarget depth{.texture = &resources.texture(in.depth)};
  cmd.begin_rendering(std::span(&layer, 1), depth, {settings.width, settings.height});
  for (const Head& head : frame.heads) {
    if (!head.visible) continue;
    const GpuSurfaces& surfaces = head.asset->surfaces;
    for (const GpuSurfaces::Blended& part : surfaces.blended) {
      const GpuMaterial& material = head.look->material(part.material);
      bind_label_surface(cmd, *pipelines_[material.double_sided], frame, head, part.page, material,
                         shows_part());
      surfaces.record(cmd, part.page, part.draw);
    }
  }
  cmd.end_rendering();
}

}  // namespace dermis::passes
