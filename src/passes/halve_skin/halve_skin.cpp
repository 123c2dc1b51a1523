// SPDX-License-Identifier: MIT
#include "passes/halve_skin/halve_skin.h"

#include "frame/resources.h"
#include "passes/bindings.h"

namespace dermis::passes {

HalveSkin::Out HalveSkin::declare(frame::Declare& d) {
  compute(d, "halve_skin.comp");
  const gpu::TextureDesc whole = d.desc(in.surface.light);
  const std::uint32_t width = (whole.width + 1) / 2, height = (whole.height + 1) / 2;
  gpu::TextureDesc leaving = screen_light(width, height);
  leaving.array = true;
  out_.surface = {
      .light = d.create("halved light", screen_light(width, height)),
      .depth_mm =
          d.create("halved depth", {.width = width, .height = height, .format = VK_FORMAT_R32_SFLOAT}),
      .surface = d.create("halved surface", {.width = width, .height = height, .format = VK_FORMAT_R32_UINT}),
      .leaving = d.create("halved skin", leaving),
      .halved = true};
  for (const frame::TextureId id :
       {in.surface.light, in.surface.depth_mm, in.surface.surface, in.surface.leaving})
    d.sample(id);
  for (const frame::TextureId id :
       {out_.surface.light, out_.surface.depth_mm, out_.surface.surface, out_.surface.leaving})
    d.write(id);
  return out_;
}

void HalveSkin::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light", resources.nearest(in.surface.light))
      .add("depth_of_skin", resources.nearest(in.surface.depth_mm))
      .add("surface_of_skin", resources.nearest(in.surface.surface))
      .add("leaving_skin", resources.nearest(in.surface.leaving))
      .add("halved_light", resources.storage(out_.surface.light))
      .add("halved_depth", resources.storage(out_.surface.depth_mm))
      .add("halved_surface", resources.storage(out_.surface.surface))
      .add("halved_leaving", resources.storage(out_.surface.leaving))
      .bind(cmd, pipeline());
  // What reads between pixels must find no skin of another frame beside them.
  const gpu::TextureDesc& halved = resources.texture(out_.surface.light).desc();
  const PixelArea area = with_rim(area_of(out_.surface, frame), {halved.width, halved.height});
  io::ScreenIo io = screen_io(resources.texture(in.surface.light).desc(), out_.surface, frame);
  io.low = area.low;
  io.size = area.size();
  dispatch(cmd, io, io.size);
}

}  // namespace dermis::passes
