// SPDX-License-Identifier: MIT
#include "render/passes/pixels/open_share/open_share.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"

namespace dermis::passes {

OpenShare::Out OpenShare::declare(frame::Declare& d) {
  compute(d, settings.samples > 1 ? "open_share.comp" : "open_share_single.comp",
          {{"sample_count", settings.samples}, {"has_layer", in.layer.valid() ? 1u : 0u}});
  const gpu::TextureDesc& depth = d.desc(in.depth);
  out_.open =
      d.create("open", {.width = depth.width, .height = depth.height, .format = VK_FORMAT_R32_SFLOAT});
  d.sample(in.depth);
  if (in.layer.valid()) d.sample(in.layer);
  d.write(out_.open);
  return out_;
}

void OpenShare::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  Bindings()
      .add("depths", resources.nearest(in.depth))
      .add("layer", resources.nearest(in.layer.valid() ? in.layer : in.depth))
      .add("open", resources.storage(out_.open))
      .bind(cmd, pipeline());
  const gpu::TextureDesc& desc = resources.texture(out_.open).desc();
  cmd.dispatch_over(pipeline(), desc.width, desc.height);
}

}  // namespace dermis::passes
