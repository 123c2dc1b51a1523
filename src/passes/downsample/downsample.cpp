// SPDX-License-Identifier: MIT
#include "passes/downsample/downsample.h"

#include <cmath>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/downsample/downsample_io.h"

namespace dermis::passes {

Downsample::Out Downsample::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  DERMIS_ASSERT_EQ(settings_.from.size(), settings_.to.size());
  in_ = in;
  d.sample(in.light);
  d.sample(in.stretch);
  d.write(in.target);
  return {in.target};
}

void Downsample::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.compute("downsample.comp");
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
}

void Downsample::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light_in", resources.sampled(in_.light, sampler_))
      .add("stretch", resources.sampled(in_.stretch, sampler_))
      .add("light_out", gpu::StorageImageBinding{&resources.texture(in_.target)})
      .bind(cmd, *pipeline_);
  for (std::size_t i = 0; i < settings_.to.size(); ++i) {
    const MapSquare &from = settings_.from[i], &to = settings_.to[i];
    if (!instance_of(frame, to).visible) continue;
    const std::uint32_t side = side_of(frame, to);
    cmd.push(
        *pipeline_,
        io::DownsampleIo{
            .origin = to.origin, .side = side, .ratio = side_of(frame, from) / side, .from = from.origin});
    cmd.dispatch_over(*pipeline_, side, side);
  }
}

std::vector<std::uint32_t> map_halvings(const gaussians::SumOfGaussians& profile, double mean_texels_per_mm,
                                        std::uint32_t map_size) {
  std::vector<std::uint32_t> halvings;
  double before_mm2 = 0;
  for (const gaussians::Gaussian& term : profile.terms) {
    const double sigma_texels = std::sqrt(before_mm2) * mean_texels_per_mm;
    std::uint32_t n = 0;
    while (n < max_halvings && sigma_texels >= (2u << n) && map_size % (2u << n) == 0) ++n;
    halvings.push_back(n);
    before_mm2 = term.variance_mm2;
  }
  return halvings;
}

}  // namespace dermis::passes
