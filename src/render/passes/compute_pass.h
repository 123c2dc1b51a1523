// SPDX-License-Identifier: MIT
// Common part of passes with one compute shader: declare() names the shader, and its pipeline is ready when
// the pass records.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <utility>

#include "frame/graph.h"
#include "gpu/cmd.h"
#include "gpu/pipelines.h"

namespace dermis::passes {

class ComputePass {
 public:
  void prepare(gpu::PipelineLibrary& library) { pipeline_ = &library.compute(shader_, constants_); }

 protected:
  void compute(frame::Declare& d, std::string shader, gpu::Constants constants = {}) {
    d.kind(frame::PassKind::compute);
    shader_ = std::move(shader);
    constants_ = std::move(constants);
  }
  const gpu::Pipeline& pipeline() const { return *pipeline_; }

  /// Dispatches one invocation per texel of width x height, rounded up to workgroups.
  template <class Io>
  void dispatch(gpu::Cmd& cmd, const Io& io, std::uint32_t width, std::uint32_t height) const {
    cmd.push(pipeline(), io);
    cmd.dispatch_over(pipeline(), width, height);
  }
  template <class Io>
  void dispatch(gpu::Cmd& cmd, const Io& io, const glm::uvec2& size) const {
    dispatch(cmd, io, size.x, size.y);
  }

 private:
  std::string shader_;
  gpu::Constants constants_;
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
