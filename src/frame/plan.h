// SPDX-License-Identifier: MIT
// A frame that can be recorded once frame/executor.h has given it memory.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "frame/graph.h"
#include "frame/resources.h"
#include "gpu/cmd.h"
#include "gpu/pipelines.h"

namespace dermis::frame {

/// A graph whose passes can be recorded. Context is what changes per frame (cameras, lights, geometry); the
/// passes define it, the frame only passes it on.
template <class Context>
class FramePlan : public FrameGraph {
 public:
  struct Step {
    std::function<void(gpu::PipelineLibrary&)> prepare;  ///< makes pipelines
    std::function<void(gpu::Cmd&, const Resources&, const Context&)> record;
  };

  /// Constructs the pass, gives it settings and inputs, lets it declare, and keeps it. A pass has:
  ///   Settings settings; In in; Out declare(Declare&); void prepare(gpu::PipelineLibrary&), unless it has no
  ///   pipelines; void record(gpu::Cmd&, const Resources&, const Context&) const.
  /// Barriers stand between passes alone: dispatches of one pass write areas that are disjoint. A validation
  /// layer that is asked to guess what shaders access (syncval_shader_accesses_heuristic) takes them for
  /// hazards.
  template <class Pass>
  typename Pass::Out add(const std::string& name, const typename Pass::In& in,
                         const typename Pass::Settings& settings = {}) {
    auto pass = std::make_shared<Pass>();
    pass->settings = settings;
    pass->in = in;
    PassNode node{.name = name};
    Declare declare(*this, node);
    typename Pass::Out out = pass->declare(declare);
    add_pass(std::move(node));
    steps_.push_back({.prepare =
                          [pass](gpu::PipelineLibrary& library) {
                            if constexpr (requires { pass->prepare(library); }) pass->prepare(library);
                          },
                      .record = [pass](gpu::Cmd& cmd, const Resources& resources,
                                       const Context& context) { pass->record(cmd, resources, context); }});
    return out;
  }

  const std::vector<Step>& steps() const { return steps_; }  ///< one per pass

 private:
  std::vector<Step> steps_;
};

}  // namespace dermis::frame
