// SPDX-License-Identifier: MIT
#include "passes/bloom/bloom.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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
  compute(d, in.smaller.valid() ? "bloom_mixed.comp" : "bloom.comp");
  gpu::TextureDesc desc = d.desc(in.picture);
  desc.usage = 0;
  if (settings.mode == Mode::downsample) {
    desc.width = (desc.width + 1) / 2;
    desc.height = (desc.height + 1) / 2;
  }
  target_ = d.create("bloom", desc);
  d.read(in.picture);
  if (in.smaller.valid()) d.sample(in.smaller);
  d.write(target_);
  return {target_};
}

void BloomStep::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  const gpu::Texture& target = resources.texture(target_);
  Bindings bindings;
  bindings.add("picture", resources.storage(in.picture)).add("target", resources.storage(target_));
  if (in.smaller.valid()) bindings.add("smaller", resources.linear(in.smaller));
  bindings.bind(cmd, pipeline());
  const io::BloomIo io{.mode = static_cast<std::uint32_t>(settings.mode),
                       .sigma = settings.sigma,
                       .share = settings.share,
                       .halvings = settings.halvings};
  dispatch(cmd, io, target.desc().width, target.desc().height);
}

namespace {

using Mode = BloomStep::Mode;

// A Gaussian, and the picture that it blurs.
struct OnLevel {
  std::uint32_t halvings = 1;
  float sigma = 0;  // pixels of that picture
};

// Returns the smallest picture on which a Gaussian has a sigma of at least 2.5 pixels, or that of half size;
// what it loses between such pixels is under 1 %. What a smaller picture adds to the variance is taken off:
// that of averaging r x r pixels into one, (1 - 1/r^2) / 12, and twice that for reading between its pixels.
OnLevel level_of(float variance) {
  OnLevel level;
  for (float r = 2;; r *= 2, ++level.halvings) {
    const auto left = [&](float side) { return variance / (side * side) - (1 - 1 / (side * side)) / 4; };
    if (left(2 * r) >= 2.5f * 2.5f) continue;

    // A Gaussian of 0.3 pixels is its middle sample to 1 %; 0 divides by 0.
    level.sigma = std::sqrt(std::max(left(r), 0.09f));
    return level;
  }
}

}  // namespace

frame::TextureId add_bloom(FramePlan& plan, frame::TextureId picture, float amount) {
  const float radius_pixels = static_cast<float>(plan.textures()[picture.index].desc.height) / 12;
  const OnLevel narrow = level_of(narrow_variance * radius_pixels * radius_pixels),
                wide = level_of(wide_variance * radius_pixels * radius_pixels);

  std::vector<frame::TextureId> halved{picture};
  while (halved.size() <= std::max(narrow.halvings, wide.halvings)) {
    const std::string name = fmt::format("bloom downsample 1/{}", 1u << halved.size());
    halved.push_back(plan.add<BloomStep>(name, {halved.back()}, {.mode = Mode::downsample}).picture);
  }

  // Blur along x and y, the wide one first: the narrow one takes it in on its own, larger picture.
  const auto blurred_x = [&](const std::string& name, const OnLevel& level) {
    return plan.add<BloomStep>(name, {halved[level.halvings]}, {.mode = Mode::blur_x, .sigma = level.sigma})
        .picture;
  };
  const frame::TextureId wide_x = blurred_x("bloom wide x", wide);
  const frame::TextureId wide_light =
      plan.add<BloomStep>("bloom wide y", {wide_x}, {.mode = Mode::blur_y, .sigma = wide.sigma}).picture;
  const frame::TextureId narrow_x = blurred_x("bloom narrow x", narrow);
  const frame::TextureId spread = plan.add<BloomStep>("bloom narrow y", {narrow_x, wide_light},
                                                      {.mode = Mode::blur_y,
                                                       .sigma = narrow.sigma,
                                                       .share = wide_weight / (narrow_weight + wide_weight),
                                                       .halvings = wide.halvings - narrow.halvings})
                                      .picture;

  // Mix with the sharp picture.
  return plan
      .add<BloomStep>("bloom combine", {picture, spread},
                      {.mode = Mode::combine, .share = amount, .halvings = narrow.halvings})
      .picture;
}

}  // namespace dermis::passes
