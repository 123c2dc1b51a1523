// SPDX-License-Identifier: MIT
#include "passes/tone_map/tone_map.h"

#include "frame/resources.h"
#include "image/colour.h"
#include "passes/bindings.h"
#include "passes/tone_map/tone_map_io.h"

namespace dermis::passes {

static_assert(static_cast<std::uint32_t>(dermis::ToneMap::natural) == TONE_MAP_NATURAL);
static_assert(static_cast<std::uint32_t>(dermis::ToneMap::neutral) == TONE_MAP_NEUTRAL);
static_assert(static_cast<std::uint32_t>(dermis::ToneMap::agx) == TONE_MAP_AGX);
static_assert(static_cast<std::uint32_t>(dermis::ToneMap::filmic) == TONE_MAP_FILMIC);
static_assert(static_cast<std::uint32_t>(dermis::ToneMap::srgb) == TONE_MAP_SRGB);
static_assert(static_cast<std::uint32_t>(dermis::ToneMap::linear) == TONE_MAP_LINEAR);

ToneMap::Out ToneMap::declare(frame::Declare& d) {
  compute(d, in.open.valid() ? "tone_map_behind.comp" : "tone_map.comp",
          {{"tone_map", static_cast<std::uint32_t>(settings.tone_map)}});
  const gpu::TextureDesc& picture = d.desc(in.picture);
  display_ = d.create("display", {.width = picture.width,
                                  .height = picture.height,
                                  .format = VK_FORMAT_R8G8B8A8_UNORM,
                                  .usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
  d.sample(in.picture);
  if (in.open.valid()) d.sample(in.open);
  d.write(display_);
  return {display_};
}

void ToneMap::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  const gpu::Texture& display = resources.texture(display_);
  Bindings bindings;
  bindings.add("picture", resources.nearest(in.picture)).add("display", resources.storage(display_));
  if (in.open.valid()) bindings.add("open", resources.nearest(in.open));
  bindings.bind(cmd, pipeline());
  if (in.open.valid()) {
    const glm::vec3& srgb = settings.behind_srgb;
    cmd.push(pipeline(), io::BehindIo{.srgb = srgb,
                                      .linear = {image::srgb_to_linear(srgb.x), image::srgb_to_linear(srgb.y),
                                                 image::srgb_to_linear(srgb.z)}});
  }
  cmd.dispatch_over(pipeline(), display.desc().width, display.desc().height);
}

}  // namespace dermis::passes
