// SPDX-License-Identifier: MIT
#include "passes/restore_skin/restore_skin.h"

#include "frame/resources.h"
#include "passes/bindings.h"

namespace dermis::passes {

RestoreSkin::Out RestoreSkin::declare(frame::Declare& d) {
  compute(d, "restore_skin.comp");
  const gpu::TextureDesc desc = d.desc(in.surface.light);
  out_.light = d.create("restored light", screen_light(desc.width, desc.height));
  for (const frame::TextureId id : {in.blurred, in.halved.depth_mm, in.halved.surface}) d.read(id);
  for (const frame::TextureId id :
       {in.halved.leaving, in.surface.light, in.surface.depth_mm, in.surface.surface, in.surface.leaving})
    d.sample(id);
  d.write(out_.light);
  return out_;
}

void RestoreSkin::prepare(gpu::PipelineLibrary& library) {
  ComputePass::prepare(library);
  scales_ = gpu::make_buffer(library.device(), "scales of skin", std::span<const float>(settings.mm_per_unit),
                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

void RestoreSkin::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("Frame", frame.frame_io)
      .add("light", resources.nearest(in.surface.light))
      .add("depth_of_skin", resources.nearest(in.surface.depth_mm))
      .add("surface_of_skin", resources.nearest(in.surface.surface))
      .add("leaving_skin", resources.nearest(in.surface.leaving))
      .add("Scales", scales_)
      .add("blurred", resources.storage(in.blurred))
      .add("halved_depth", resources.storage(in.halved.depth_mm))
      .add("halved_surface", resources.storage(in.halved.surface))
      .add("halved_leaving", resources.nearest(in.halved.leaving))
      .add("target", resources.storage(out_.light))
      .bind(cmd, pipeline());
  const io::ScreenIo io = screen_io(resources.texture(out_.light).desc(), in.surface, frame);
  dispatch(cmd, io, io.size);
}

}  // namespace dermis::passes
