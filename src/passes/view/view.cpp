// SPDX-License-Identifier: MIT
#include "passes/view/view.h"

#include "frame/executor.h"
#include "passes/bindings.h"
#include "passes/view/view_io.h"

namespace dermis::passes {

View::Out View::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  in_ = in;
  const gpu::TextureDesc& picture = d.desc(in.picture);
  display_ = d.create("display", {.width = picture.width,
                                  .height = picture.height,
                                  .format = VK_FORMAT_R8G8B8A8_UNORM,
                                  .usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
  d.sample(in.picture);
  d.write(display_);
  return {display_};
}

void View::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.compute("view.comp");
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
}

void View::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData&) const {
  const gpu::Texture& display = resources.texture(display_);
  Bindings()
      .add("picture", resources.sampled(in_.picture, sampler_))
      .add("display", gpu::StorageImageBinding{&display})
      .bind(cmd, *pipeline_);
  cmd.push(*pipeline_, io::ViewIo{.transform = static_cast<std::uint32_t>(settings_.transform)});
  cmd.dispatch_over(*pipeline_, display.desc().width, display.desc().height);
}

Resolve::Out Resolve::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  in_ = in;
  gpu::TextureDesc desc = d.desc(in.picture);
  desc.samples = 1;
  desc.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  target_ = d.create("picture", desc);
  d.colour(in.picture);
  d.colour(target_);
  return {target_};
}

void Resolve::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData&) const {
  const gpu::Texture& picture = resources.texture(in_.picture);
  const gpu::ColourTarget target{.texture = &picture, .resolve = &resources.texture(target_)};
  cmd.begin_rendering(std::span(&target, 1), {}, {picture.desc().width, picture.desc().height});
  cmd.end_rendering();
}

}  // namespace dermis::passes
