// SPDX-License-Identifier: MIT
#include "passes/final_pass/final_pass.h"

#include "frame/resources.h"
#include "passes/draw_skin.h"

namespace dermis::passes {

FinalPass::Out FinalPass::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  shading_ = SkinShading(settings.look, in.lights);
  shading_.declare(d);
  d.colour(in.colour);
  d.depth(in.depth);
  return {in.colour, in.depth};
}

void FinalPass::prepare(gpu::PipelineLibrary& library) {
  for (const SkinVariant& variant : shading_.variants())
    for (const bool double_sided : {false, true})
      pipelines_[variant.index()][double_sided] = &library.graphics(
          {.vertex = "final_pass.vert",
           .fragment = shading_.through(variant) ? "final_pass_through.frag" : "final_pass.frag",
           .constants = shading_.constants(variant),
           .colour_formats = {settings.format.colour},
           .depth_format = settings.format.depth,
           .samples = settings.samples,
           .cull = double_sided ? gpu::Cull::none : gpu::Cull::back,
           .depth_test = true,
           .depth_write = true,
           .depth_compare = settings.format.nearer()});
  shading_.prepare(library);
}

bool FinalPass::draws(const FrameData& frame) const {
  return instance_of(frame, settings.look.square).is_drawn();
}

void FinalPass::begin(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                      bool clear) const {
  begin_picture(cmd, resources.texture(in.colour), resources.texture(in.depth), clear, frame.area);
}

void FinalPass::draw(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const MapSquare& square = settings.look.square;
  const Instance& instance = instance_of(frame, square);
  const std::uint32_t mesh = mesh_in_asset(frame, square);
  Bindings bindings;
  shading_.offer(bindings, resources, frame);
  draw_skin(
      cmd, instance, mesh, bindings,
      [&](const GpuDraw& draw, const GpuMaterial& material) {
        return pipelines_[shading_.variant_of(frame, draw, material).index()][material.double_sided];
      },
      [io = shading_.io(frame)](const GpuMaterial&) { return io; }, first_corners(instance, mesh));
}

}  // namespace dermis::passes
