// SPDX-License-Identifier: MIT
#include "passes/downsample/downsample.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/downsample/downsample_io.h"

namespace dermis::passes {

Downsample::Out Downsample::declare(frame::Declare& d) {
  compute(d, "downsample.comp");
  DERMIS_ASSERT_EQ(settings.from.size(), settings.to.size());
  d.read(in.light);
  d.sample(in.stretch);
  d.write(in.target);
  return {in.target};
}

void Downsample::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light_in", resources.storage(in.light))
      .add("stretch", resources.nearest(in.stretch))
      .add("light_out", resources.storage(in.target))
      .bind(cmd, pipeline());

  for (std::size_t i = 0; i < settings.to.size(); ++i) {
    if (!instance_of(frame, settings.to[i]).visible || !terms_of(frame, settings.to[i]).any) continue;
    const UsedSquare from = used_square(frame, settings.from[i]), to = used_square(frame, settings.to[i]);
    const io::DownsampleIo io{
        .origin = to.origin, .side = to.side, .ratio = from.side / to.side, .from = from.origin};
    dispatch(cmd, io, to.side, to.side);
  }
}

}  // namespace dermis::passes
