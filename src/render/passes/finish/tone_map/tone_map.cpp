// SPDX-License-Identifier: MIT
#include "render/passes/finish/tone_map/tone_map.h"

#include "frame/resources.h"
#include "image/colour.h"
#include "render/passes/bindings.h"
#include "render/passes/finish/tone_map/tone_map_io.h"

namespace dermis::passes {

static_assert(static_cast<std::uint32_t>(dermis::ToneMap::natural) == TONE_MAP_NATURAL);
static_assert(static_cast<std::uint32_t>(dermis::ToneMap::neutral) == TONE_MAP_NEUTRAL);
static_assert(static_cast<std::uint32_t>(dermis::ToneMap::agx) == TONE_MAP_AGX);
static_assert(static_cast<std::uint32_t>(dermis::ToneMap::filmic) == TONE_MAP_FILMIC);
static_assert(static_cast<std::uint32_t>(dermis::ToneMap::srgb) == TONE_MAP_SRGB);
static_assert(static_cast<std::uint32_t>(dermis::ToneMap::linear) == TONE_MAP_LINEAR);

ToneMap::Out ToneMap::declare(frame::Declare& d) {
  compute(d, "tone_map.comp",
          {{"tone_map", static_cast<std::uint32_t>(settings.tone_map)},
           {"blooms", blooms() ? 1u : 0u},
           {"behind", in.open.valid() ? 1u : 0u},
           {"displays", settings.display ? 1u : 0u}});
  gpu::TextureDesc desc = d.desc(in.picture);
  desc.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  out_.light = d.create("light", desc);
  if (!settings.display) desc.width = desc.height = 1;  // for the binding
  desc.format = VK_FORMAT_R8G8B8A8_UNORM;
  out_.display = d.create("display", desc);
  d.write(out_.display);
  d.sample(in.picture);
  if (in.open.valid()) d.sample(in.open);
  if (blooms())
    for (const SpreadLight& spread : {settings.spread.narrow, settings.spread.wide}) d.sample(spread.picture);
  d.write(out_.light);
  return out_;
}

void ToneMap::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  const SpreadLight &narrow = settings.spread.narrow, &wide = settings.spread.wide;
  Bindings()
      .add("picture", resources.nearest(in.picture))
      .add("open", resources.nearest(in.open.valid() ? in.open : in.picture))
      .add("narrow", resources.linear(blooms() ? narrow.picture : in.picture))
      .add("wide", resources.linear(blooms() ? wide.picture : in.picture))
      .add("light", resources.storage(out_.light))
      .add("display", resources.storage(out_.display))
      .bind(cmd, pipeline());

  const glm::vec3& srgb = settings.behind_srgb;
  const gpu::TextureDesc& size = resources.texture(out_.light).desc();
  dispatch(cmd,
           io::ToneMapIo{.srgb = srgb,
                         .linear = {image::srgb_to_linear(srgb.x), image::srgb_to_linear(srgb.y),
                                    image::srgb_to_linear(srgb.z)},
                         .narrow = settings.bloom * narrow.weight,
                         .wide = settings.bloom * wide.weight,
                         .narrow_halvings = narrow.halvings,
                         .wide_halvings = wide.halvings},
           size.width, size.height);
}

}  // namespace dermis::passes
