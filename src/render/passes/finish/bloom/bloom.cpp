// SPDX-License-Identifier: MIT
#include "render/passes/finish/bloom/bloom.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "frame/resources.h"
#include "frame/together.h"
#include "render/passes/bindings.h"
#include "render/passes/finish/bloom/bloom_io.h"

namespace dermis::passes {
namespace {

// [DLE07]: weights and variances of the two Gaussians for d = 1. For a filter of unit weight, divide the
// weights by their sum.
constexpr float narrow_weight = 0.0174f, wide_weight = 0.192f, narrow_variance = 0.008f,
                wide_variance = 0.0576f;

}  // namespace

BloomStep::Out BloomStep::declare(frame::Declare& d) {
  compute(d, settings.halvings > 0 ? "bloom_downsample.comp" : "bloom_blur.comp");
  d.read(in.picture);
  d.write(in.target);
  return {};
}

void BloomStep::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  Bindings()
      .add("picture", resources.storage(in.picture))
      .add("target", resources.storage(in.target))
      .bind(cmd, pipeline());
  const gpu::TextureDesc& target = resources.texture(in.target).desc();
  constexpr std::uint32_t turns = BLOOM_HEIGHT / BLOOM_ROWS_AT_ONCE;
  dispatch(cmd, io::BloomIo{.sigma = settings.sigma, .halvings = settings.halvings}, target.width,
           settings.halvings > 0 ? target.height : (target.height + turns - 1) / turns);
}

namespace {

// A Gaussian, and the picture that it blurs.
struct OnLevel {
  std::uint32_t halvings = 1;
  float sigma = 0;  // pixels of that picture
};

// Returns the smallest picture on which a Gaussian has a sigma of at least 2.5 pixels, or that of half size.
// Its loss between such pixels is under 1 %. The variance that a smaller picture adds is taken off: (1 -
// 1/r^2) / 12 for averaging r x r pixels into one, and twice that for reading between its pixels.
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

Bloom add_bloom(FramePlan& plan, frame::TextureId picture) {
  const gpu::TextureDesc full = plan.textures()[picture.index].desc;
  const float radius_pixels = static_cast<float>(full.height) / 12;
  Bloom bloom{.narrow = {.weight = narrow_weight / (narrow_weight + wide_weight)},
              .wide = {.weight = wide_weight / (narrow_weight + wide_weight)}};

  frame::Together<BloomStep>::In smaller, blurs;
  const auto add = [&](const std::string& name, float variance, SpreadLight& spread) {
    const OnLevel level = level_of(variance * radius_pixels * radius_pixels);
    const std::uint32_t side = 1u << level.halvings;
    gpu::TextureDesc desc = full;
    desc.usage = 0;
    desc.width = (full.width + side - 1) / side;
    desc.height = (full.height + side - 1) / side;
    const frame::TextureId start = plan.texture(name + " start", desc);
    spread.picture = plan.texture(name, desc);
    spread.halvings = level.halvings;

    smaller.members.push_back({{picture, start}, {.halvings = level.halvings}});
    blurs.members.push_back({{start, spread.picture}, {.sigma = level.sigma}});
  };
  add("bloom narrow", narrow_variance, bloom.narrow);
  add("bloom wide", wide_variance, bloom.wide);

  plan.add<frame::Together<BloomStep>>("bloom downsample", smaller);
  plan.add<frame::Together<BloomStep>>("bloom blur", blurs);
  return bloom;
}

}  // namespace dermis::passes
