// SPDX-License-Identifier: MIT
#include "passes/count/count.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/count/count_io.h"

namespace dermis::passes {

Count::Out Count::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  d.runs(frame::Runs::for_statistics);
  in_ = in;
  d.sample(in.picture);
  d.write(in.counters);
  return {};
}

void Count::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.compute("count.comp");
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
}

void Count::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Texture& picture = resources.texture(in_.picture);
  Bindings()
      .add("picture", resources.sampled(in_.picture, sampler_))
      .add("Counters", resources.buffer(in_.counters))
      .bind(cmd, *pipeline_);
  const auto count = [&](glm::uvec2 origin, glm::uvec2 extent) {
    cmd.push(*pipeline_, io::CountIo{.origin = origin,
                                     .extent = extent,
                                     .slot = settings_.slot,
                                     .threshold = settings_.threshold,
                                     .absolute = settings_.absolute ? 1u : 0u});
    cmd.dispatch_over(*pipeline_, extent.x, extent.y);
  };
  if (settings_.squares.empty()) count({0, 0}, {picture.desc().width, picture.desc().height});
  for (const MapSquare& square : settings_.squares)
    if (instance_of(frame, square).visible) count(square.origin, glm::uvec2(side_of(frame, square)));
}

ClearCounters::Out ClearCounters::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::copy);
  d.runs(frame::Runs::for_statistics);
  in_ = in;
  d.copy_to(in.counters);
  return {};
}

void ClearCounters::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  cmd.fill(resources.buffer(in_.counters), 0);
}

}  // namespace dermis::passes
