// SPDX-License-Identifier: MIT
// Gives a plan memory and pipelines, and records it. Recording creates nothing and submits nothing, so that
// an engine can pass its own command buffer; run() also submits and waits.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "base/core/hooks.h"
#include "frame/barriers.h"
#include "frame/plan.h"
#include "frame/resources.h"
#include "gpu/cmd.h"
#include "gpu/device.h"
#include "gpu/timer.h"

namespace dermis::frame {

struct FrameTime {
  double total_ms = 0;
  std::vector<gpu::Timing> passes;  ///< in plan order; empty unless timed
};

/// Memory and barriers of a graph. A function records the passes, so that nothing here depends on the context
/// of a frame.
class GraphExecutor {
 public:
  /// For tests, before a frame: fills new textures, and transient ones of the previous frame, with values
  /// that no picture may show (gpu::poison). A driver that keeps contents which a frame declares undefined
  /// then reveals a pass that reads them.
  void poison();
  /// Sets a texture of Lifetime::of_host for the frames that follow.
  void set_texture_of_host(TextureId id, gpu::Texture texture);
  /// Returns the layout in which the last recorded frame leaves a texture.
  VkImageLayout layout_of(TextureId id) const { return layouts_[id.index]; }
  bool separate_submissions() const { return separate_; }
  const RecordedWork& recorded() const { return recorded_; }  ///< by the last frame

  const FrameGraph& graph() const { return graph_; }
  const Resources& resources() const { return resources_; }
  gpu::Device& device() const { return library_->device(); }

 protected:
  using RecordPass = std::function<void(gpu::Cmd&, std::size_t pass)>;

  GraphExecutor(gpu::PipelineLibrary& library, const FrameGraph& graph);
  void record(VkCommandBuffer commands, const RecordPass& record_pass, FrameKind kind, gpu::Timer* timer);
  FrameTime run(const RecordPass& record_pass);

 private:
  using Barriers = std::vector<std::vector<Barrier>>;  // by pass

  VkImageLayout old_layout(const Barrier& b) const;
  VkImageMemoryBarrier2 image_barrier(const Barrier& b);
  const Barriers& barriers_of(const FrameKind& kind);
  bool is_of_host(const Barrier& b) const;
  void record_barriers(gpu::Cmd& cmd, const std::vector<Barrier>& barriers);

  gpu::PipelineLibrary* library_;
  FrameGraph graph_;
  std::map<FrameKind, Barriers> barriers_;  // of the kinds recorded so far
  Resources resources_;
  std::vector<VkImageLayout> layouts_;  // current layout of each texture
  bool first_ = true;                   // no frame has been recorded
  bool separate_ = false;
  RecordedWork recorded_;
};

template <class Context>
class Executor : public GraphExecutor {
 public:
  /// Makes pipelines and resources. Throws DeviceError if memory does not suffice.
  Executor(gpu::PipelineLibrary& library, const FramePlan<Context>& plan)
      : GraphExecutor(library, plan), steps_(plan.steps()) {
    Steps pipelines("making pipelines", steps_.size());
    for (const auto& step : steps_) {
      step.prepare(library);
      pipelines.done();
    }
  }

  /// Records one frame with a debug label and (with a timer) a pair of time stamps around each pass. The
  /// first frame has the passes that run once, whatever `kind` says. Barriers assume that the previous frame
  /// was of the same kind: between two of different kinds, wait for the device.
  void record(VkCommandBuffer commands, const Context& context, const FrameKind& kind = {},
              gpu::Timer* timer = nullptr) {
    GraphExecutor::record(commands, recording(context), kind, timer);
  }

  /// Records, submits and waits, and times each pass. Where time stamps between passes are not reliable
  /// (software devices), each pass is a submission of its own and is timed on the host: see
  /// separate_submissions().
  FrameTime run(const Context& context) { return GraphExecutor::run(recording(context)); }
  /// Records, submits and waits, untimed.
  void draw(const Context& context, const FrameKind& kind) {
    device().run([&](VkCommandBuffer commands) { record(commands, context, kind); });
  }

 private:
  RecordPass recording(const Context& context) const {
    return [&](gpu::Cmd& cmd, std::size_t pass) { steps_[pass].record(cmd, resources(), context); };
  }

  std::vector<typename FramePlan<Context>::Step> steps_;
};

}  // namespace dermis::frame
