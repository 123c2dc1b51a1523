// SPDX-License-Identifier: MIT
// Gives a plan its memory and pipelines, and records it. Recording creates nothing and submits nothing, so an
// engine can pass its own command buffer; run() submits and waits for those who have none.
#pragma once

#include <vector>

#include "frame/barriers.h"
#include "frame/plan.h"
#include "gpu/cmd.h"
#include "gpu/device.h"
#include "gpu/timer.h"

namespace dermis::frame {

/// What a recording pass looks its handles up in.
class Resources {
 public:
  const gpu::Texture& texture(TextureId id) const { return at(textures_, id.index); }
  const gpu::Buffer& buffer(BufferId id) const { return at(buffers_, id.index); }
  /// The texture in the layout that sampling passes see it in.
  gpu::SampledBinding sampled(TextureId id, VkSampler sampler) const { return {&texture(id), sampler}; }

 private:
  template <class T>
  static const T& at(const std::vector<T>& all, std::uint32_t index) {
    DERMIS_ASSERT_LT(index, all.size());
    return all[index];
  }
  friend class Executor;
  std::vector<gpu::Texture> textures_;
  std::vector<gpu::Buffer> buffers_;
};

struct FrameTime {
  double total_ms = 0;
  std::vector<gpu::Timing> passes;  ///< in plan order; empty unless timed
};

class Executor {
 public:
  /// Makes pipelines and resources. DeviceError if memory does not suffice.
  Executor(gpu::PipelineLibrary& library, FramePlan plan);

  /// Records one frame with a debug label and (if timer) a time stamp pair around each pass; a full frame
  /// with the passes that stand only there. The first frame must be full. The barriers take each frame for
  /// one like itself: between a full one and one that is not, wait for the device.
  void record(VkCommandBuffer commands, const FrameData& frame, gpu::Timer* timer = nullptr,
              bool full = false);

  /// Records, submits and waits, timing each pass. Where time stamps between passes cannot be trusted
  /// (software devices), each pass is its own submission and is timed on the host: see
  /// separate_submissions().
  FrameTime run(const FrameData& frame);
  /// A full frame, untimed.
  void run_full(const FrameData& frame) {
    device().run([&](VkCommandBuffer commands) { record(commands, frame, nullptr, true); });
  }
  /// For tests, before a frame: fills what is of no frame yet, and what the frame before has left in
  /// transient textures, with values that no picture may show (gpu::poison). Where the driver keeps contents
  /// that a frame declares undefined, what reads them shows it.
  void poison();
  /// In which the last recorded frame leaves a texture.
  VkImageLayout layout_of(TextureId id) const { return layouts_[id.index]; }
  bool separate_submissions() const { return separate_; }

  const FramePlan& plan() const { return plan_; }
  const Resources& resources() const { return resources_; }
  gpu::Device& device() const { return library_->device(); }

 private:
  VkImageMemoryBarrier2 image_barrier(const Barrier& b);
  void record_pass(gpu::Cmd& cmd, std::size_t index, const FrameData& frame, bool full);

  gpu::PipelineLibrary* library_;
  FramePlan plan_;
  std::vector<std::vector<Barrier>> barriers_[2];  // of frames that are not full, and of full ones
  Resources resources_;
  std::vector<VkImageLayout> layouts_;  // that each texture was left in
  bool separate_ = false;
};

}  // namespace dermis::frame
