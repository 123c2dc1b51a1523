// SPDX-License-Identifier: MIT
#include "passes/upsample/upsample.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/upsample/upsample_io.h"

namespace dermis::passes {

Upsample::Out Upsample::declare(frame::Declare& d) {
  compute(d, "upsample.comp");
  DERMIS_ASSERT_EQ(settings.from.size(), settings.to.size());
  d.sample(in.light);
  d.sample(in.joining);
  d.write(in.target);
  return {};
}

void Upsample::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light_in", resources.nearest(in.light))
      .add("joining", resources.nearest(in.joining))
      .add("light_out", resources.storage(in.target))
      .bind(cmd, pipeline());

  for (std::size_t i = 0; i < settings.to.size(); ++i) {
    const MappedTerms terms = terms_of(frame, settings.to[i]);
    if (!instance_of(frame, settings.to[i]).visible || !terms.any || terms.first_step > settings.step)
      continue;

    const UsedSquare from = used_square(frame, settings.from[i]), to = used_square(frame, settings.to[i]);
    io::UpsampleIo io{.origin = to.origin,
                      .side = to.side,
                      .ratio = to.side / from.side,
                      .from = from.origin,
                      .joins = glm::vec3(0)};
    if (settings.joins && terms.first_step < settings.step) {
      const auto& [r, g, b] = terms.weights[*settings.joins];
      io.joins = {r, g, b};
    }
    dispatch(cmd, io, to.side, to.side);
  }
}

}  // namespace dermis::passes
