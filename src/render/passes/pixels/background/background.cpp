// SPDX-License-Identifier: MIT
#include "render/passes/pixels/background/background.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/pixels/background/background_io.h"

namespace dermis::passes {

static_assert(static_cast<std::uint32_t>(Behind::Kind::studio) == BEHIND_STUDIO);
static_assert(static_cast<std::uint32_t>(Behind::Kind::environment) == BEHIND_ENVIRONMENT);

Background::Out Background::declare(frame::Declare& d) {
  compute(d, "background.comp", {{"kind", static_cast<std::uint32_t>(settings.behind.kind)}});
  gpu::TextureDesc desc = d.desc(in.picture);
  desc.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  out_.picture = d.create("picture and background", desc);
  d.sample(in.picture);
  d.sample(in.open);
  d.write(out_.picture);
  return out_;
}

void Background::prepare(gpu::PipelineLibrary& library) {
  ComputePass::prepare(library);
  around_ = library.sampler({.filter = gpu::Filter::linear, .u = gpu::Address::repeat});
}

void Background::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Texture& nothing = frame.heads.front().asset->white();
  const gpu::Texture* const shown = frame.environment_picture;
  Bindings()
      .add("picture", resources.nearest(in.picture))
      .add("open", resources.nearest(in.open))
      .add("Frame", frame.frame_io)
      .add("environment_map", gpu::SampledBinding{shown ? shown : &nothing, around_})
      .add("target", resources.storage(out_.picture))
      .bind(cmd, pipeline());

  const io::BackgroundIo io{.world_from_clip = glm::inverse(frame.camera.clip_from_world),
                            .has_picture = shown ? 1u : 0u};
  const gpu::TextureDesc& desc = resources.texture(out_.picture).desc();
  dispatch(cmd, io, desc.width, desc.height);
}

}  // namespace dermis::passes
