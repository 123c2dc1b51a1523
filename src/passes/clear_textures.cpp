// SPDX-License-Identifier: MIT
#include "passes/clear_textures.h"

#include "frame/resources.h"
#include "passes/targets.h"

namespace dermis::passes {

ClearTextures::Out ClearTextures::declare(frame::Declare& d) {
  d.kind(frame::PassKind::copy);
  for (const frame::TextureId texture : in.textures) d.copy_to(texture);
  return {};
}

void ClearTextures::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  for (const frame::TextureId texture : in.textures) cmd.clear(resources.texture(texture), no_light);
}

}  // namespace dermis::passes
