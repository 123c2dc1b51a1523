// SPDX-License-Identifier: MIT
#include "passes/count/count.h"

#include "frame/executor.h"
#include "passes/bindings.h"
#include "passes/count/count_io.h"

namespace dermis::passes {

Count::Out Count::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  d.only_when_counting();
  in_ = in;
  d.sample(in.picture);
  d.write(in.counters);
  return {};
}

void Count::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.compute("count.comp");
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
}

void Count::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData&) const {
  const gpu::Texture& picture = resources.texture(in_.picture);
  Bindings().add("picture", resources.sampled(in_.picture, sampler_)).add("Counters", resources.buffer(in_.counters)).bind(cmd, *pipeline_);
  const io::CountIo io{.extent = {picture.desc().width, picture.desc().height}, .slot = settings_.slot, .threshold = settings_.threshold};
  cmd.push(*pipeline_, io);
  cmd.dispatch_over(*pipeline_, io.extent.x, io.extent.y);
}

ClearCounters::Out ClearCounters::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::copy);
  d.only_when_counting();
  in_ = in;
  d.copy_to(in.counters);
  return {};
}

void ClearCounters::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData&) const {
  cmd.fill(resources.buffer(in_.counters), 0);
}

}  // namespace dermis::passes
