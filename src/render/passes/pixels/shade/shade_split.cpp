// SPDX-License-Identifier: MIT
#include "render/passes/pixels/shade/shade_split.h"

#include "frame/resources.h"
#include "render/passes/pixels/shade/shade_parts.h"

namespace dermis::passes {

ShadeSplit::Out ShadeSplit::declare(frame::Declare& d) {
  d.kind(frame::PassKind::compute);
  DERMIS_ASSERT(settings.look.terms.empty());
  shading_ = SkinShading(settings.look, in.lights);
  shading_.declare(d);
  in.entries.declare_shading(d);
  d.read(in.entries.samples);
  d.write(in.surface.light);
  d.write(in.surface.depth_mm);
  d.write(in.surface.surface);
  d.write(in.surface.leaving);
  return {};
}

void ShadeSplit::prepare(gpu::PipelineLibrary& library) {
  for (const SkinVariant& variant : shading_.variants()) {
    const char* shader = shading_.through(variant) ? "shade_split_through.comp" : "shade_split.comp";
    pipelines_[variant.index()] = &library.compute(shader, shading_.entry_constants(variant));
  }
  shading_.prepare(library);

  const auto& [r, g, b] = settings.blurred;
  const io::SplitIo split{
      .blurred = {r, g, b},
      .mm_per_unit = static_cast<float>(settings.mm_per_unit),
      .mesh = static_cast<float>(static_cast<int>(settings.look.square.mesh) - SURFACE_MESH_MIDDLE),
      .head = settings.look.square.head,
      .first_part = settings.first_part_of_head,
      .end_part = settings.end_part_of_head};
  split_ = gpu::make_buffer(library.device(), "split skin", std::span<const io::SplitIo>(&split, 1),
                            VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
}

void ShadeSplit::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings bindings;
  bindings.add("Split", split_)
      .add("samples_of_pixels", resources.storage(in.entries.samples))
      .add("light_of_skin", resources.storage(in.surface.light))
      .add("depth_of_skin", resources.storage(in.surface.depth_mm))
      .add("surface_of_skin", resources.storage(in.surface.surface))
      .add("leaving_skin", resources.storage(in.surface.leaving));
  shade_parts(cmd, resources, frame, {settings.look.square, settings.first_part}, in.entries, shading_,
              pipelines_, bindings);
}

}  // namespace dermis::passes
