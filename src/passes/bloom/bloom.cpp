// SPDX-License-Identifier: MIT
#include "passes/bloom/bloom.h"

#include <algorithm>
#include <cmath>

#include "frame/resources.h"
#include "passes/bindings.h"

namespace dermis::passes {
namespace {

// [DLE07]: weights and variances of the two Gaussians for d = 1. For a filter of unit weight, divide the
// weights by their sum.
constexpr float narrow_weight = 0.0174f, wide_weight = 0.192f, narrow_variance = 0.008f,
                wide_variance = 0.0576f;

}  // namespace

BloomStep::Out BloomStep::declare(frame::Declare& d) {
  compute(d, "bloom.comp");
  gpu::TextureDesc desc = d.desc(in.picture);
  desc.usage = 0;
  if (settings.mode == Mode::downsample) {
    desc.width = (desc.width + 1) / 2;
    desc.height = (desc.height + 1) / 2;
  }
  target_ = d.create("bloom", desc);
  d.sample(in.picture);
  if (in.narrow.valid()) d.sample(in.narrow);
  if (in.wide.valid()) d.sample(in.wide);
  d.write(target_);
  return {target_};
}

void BloomStep::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  const gpu::Texture& target = resources.texture(target_);
  const auto or_picture = [&](frame::TextureId id) { return resources.linear(id.valid() ? id : in.picture); };
  Bindings()
      .add("picture", resources.linear(in.picture))
      .add("narrow", or_picture(in.narrow))
      .add("wide", or_picture(in.wide))
      .add("target", resources.storage(target_))
      .bind(cmd, pipeline());
  constexpr float total = narrow_weight + wide_weight;
  const io::BloomIo io{.mode = static_cast<std::uint32_t>(settings.mode),
                       .sigma = settings.sigma,
                       .weight_narrow = narrow_weight / total,
                       .weight_wide = wide_weight / total,
                       .amount = settings.amount};
  dispatch(cmd, io, target.desc().width, target.desc().height);
}

frame::TextureId add_bloom(FramePlan& plan, frame::TextureId picture, float amount) {
  using Mode = BloomStep::Mode;
  // The filter's radius d, in pixels of the half-size picture.
  const float radius_pixels = static_cast<float>(plan.textures()[picture.index].desc.height) / 12 / 2;

  // Downsample once.
  const frame::TextureId half =
      plan.add<BloomStep>("bloom downsample", {picture, {}, {}}, {.mode = Mode::downsample}).picture;

  // Blur twice, each along x and y. A Gaussian of 0.3 pixels is its middle sample to 1 %; 0 divides by 0.
  const auto blurred = [&](const char* name, float variance) {
    const float sigma = std::max(std::sqrt(variance) * radius_pixels, 0.3f);
    const auto x =
        plan.add<BloomStep>(std::string(name) + " x", {half, {}, {}}, {.mode = Mode::blur_x, .sigma = sigma});
    return plan
        .add<BloomStep>(std::string(name) + " y", {x.picture, {}, {}}, {.mode = Mode::blur_y, .sigma = sigma})
        .picture;
  };

  const frame::TextureId narrow = blurred("bloom narrow", narrow_variance);
  const frame::TextureId wide = blurred("bloom wide", wide_variance);

  // Mix with the sharp picture.
  return plan
      .add<BloomStep>("bloom combine", {picture, narrow, wide}, {.mode = Mode::combine, .amount = amount})
      .picture;
}

}  // namespace dermis::passes
