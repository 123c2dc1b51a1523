// SPDX-License-Identifier: MIT
#include "render/passes/pixels/resolve/resolve.h"

#include "frame/resources.h"

namespace dermis::passes {

Resolve::Out Resolve::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  gpu::TextureDesc desc = d.desc(in.picture);
  desc.samples = 1;
  desc.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  target_ = d.create("picture", desc);
  d.colour(in.picture);
  d.colour(target_);
  return {target_};
}

void Resolve::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  const gpu::Texture& picture = resources.texture(in.picture);
  const gpu::ColourTarget target{.texture = &picture, .resolve = &resources.texture(target_)};
  cmd.begin_rendering(std::span(&target, 1), {}, {picture.desc().width, picture.desc().height});
  cmd.end_rendering();
}

}  // namespace dermis::passes
