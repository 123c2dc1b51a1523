// SPDX-License-Identifier: MIT
#include "render/passes/screen/clear_surface.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"

namespace dermis::passes {

ClearSurface::Out ClearSurface::declare(frame::Declare& d) {
  compute(d, "clear_surface.comp");
  for (const frame::TextureId map : {in.light, in.depth_mm, in.surface}) d.write(map);
  return {};
}

void ClearSurface::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  const gpu::TextureDesc& desc = resources.texture(in.light).desc();
  Bindings()
      .add("light", resources.storage(in.light))
      .add("depth_mm", resources.storage(in.depth_mm))
      .add("surface", resources.storage(in.surface))
      .bind(cmd, pipeline());
  dispatch(cmd, glm::uvec2(desc.width, desc.height), desc.width, desc.height);
}

}  // namespace dermis::passes
