// SPDX-License-Identifier: MIT
#include "render/passes/pixels/host_depth/host_depth.h"

#include "render/passes/asset/offer.h"
#include "render/passes/draw_skin.h"
#include "render/passes/pixels/host_depth/host_depth_io.h"
#include "render/passes/targets.h"

namespace dermis::passes {
namespace {

io::HostDepthIo io_of(const HostDepthTarget& target, const Head& head) {
  return {.clip_from_world = target.clip_from_world,
          .world_from_asset = similarity_io(head.world_from_asset)};
}

}  // namespace

HostDepth::HostDepth(gpu::PipelineLibrary& library, const HostDepthFormat& format) {
  for (const bool cut_out : {false, true})
    for (const bool culled : {false, true})
      pipelines_[cut_out][culled] =
          &library.graphics({.vertex = "host_depth.vert",
                             .fragment = cut_out ? "shadow.frag" : "",
                             .constants = {},
                             .colour_formats = {},
                             .depth_format = format.format,
                             .samples = format.samples,
                             .cull = culled ? gpu::Cull::back : gpu::Cull::none,
                             .depth_test = true,
                             .depth_write = true,
                             .depth_compare = PictureFormat{.reversed_depth = format.reversed}.nearer()});
}

void HostDepth::draw_skin(gpu::Cmd& cmd, const Head& head, const HostDepthTarget& target) const {
  Bindings bindings;
  bindings.add("Placements", head.asset->unmoved);
  for (std::size_t mesh = 0; mesh < head.asset->skin.size(); ++mesh)
    passes::draw_skin(
        cmd, head, mesh, bindings,
        [&](const GpuDraw&, const GpuMaterial& material) {
          return material.alpha_mode == AssetAlpha::blend ? nullptr : &pipeline_of(material, target.cull);
        },
        [&](const GpuDraw&, const GpuMaterial&) { return io_of(target, head); });
}

void HostDepth::draw_surfaces(gpu::Cmd& cmd, const Head& head, const HostDepthTarget& target) const {
  const GpuSurfaces& surfaces = head.asset->surfaces;
  for (const GpuSurfaces::Group& group : surfaces.groups) {
    const GpuMaterial& material = head.look->material(group.material);
    const gpu::Pipeline& pipeline = pipeline_of(material, target.cull);
    Bindings bindings;
    offer_page(head, group.page, bindings);
    material.offer(bindings);
    bindings.bind(cmd, pipeline);
    cmd.push(pipeline, io_of(target, head));
    for (const GpuSurfaces::Draw& draw : group.draws) surfaces.record(cmd, group.page, draw);
  }
}

void HostDepth::record(gpu::Cmd& cmd, const HostDepthTarget& target, std::span<const Head> heads) const {
  cmd.begin_rendering_area({}, gpu::DepthTarget{.texture = target.depth}, target.area, target.y_down);
  for (const Head& head : heads) {
    draw_skin(cmd, head, target);
    draw_surfaces(cmd, head, target);
  }
  cmd.end_rendering();
}

}  // namespace dermis::passes
