// SPDX-License-Identifier: MIT
#include "passes/downsample/downsample.h"

#include <cmath>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/downsample/downsample_io.h"

namespace dermis::passes {

Downsample::Out Downsample::declare(frame::Declare& d) {
  compute(d, "downsample.comp", {{"smoothed", settings.smoothed ? 1u : 0u}});
  DERMIS_ASSERT_EQ(settings.from.size(), settings.to.size());
  d.read(in.light);
  d.read(in.start);
  d.sample(in.stretch);
  d.write(in.target);
  return {in.target};
}

void Downsample::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  frame::TextureId bound;
  for (std::size_t i = 0; i < settings.to.size(); ++i) {
    const MappedTerms terms = terms_of(frame, settings.to[i]);
    if (!instance_of(frame, settings.to[i]).visible || !terms.any) continue;

    const frame::TextureId light = terms.first_step < settings.next_step ? in.light : in.start;
    if (light != bound)
      Bindings()
          .add("light_in", resources.storage(light))
          .add("stretch", resources.nearest(in.stretch))
          .add("light_out", resources.storage(in.target))
          .bind(cmd, pipeline());
    bound = light;

    const UsedSquare from = used_square(frame, settings.from[i]), to = used_square(frame, settings.to[i]);
    const io::DownsampleIo io{
        .origin = to.origin, .side = to.side, .ratio = from.side / to.side, .from = from.origin};
    dispatch(cmd, io, to.side, to.side);
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
