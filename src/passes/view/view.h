// SPDX-License-Identifier: MIT
/// The view transform: from linear radiance to eight bits for a display.
#pragma once

#include "frame/plan.h"
#include "passes/frame_data.h"

namespace dermis::passes {

enum class ViewTransform : std::uint32_t { filmic, srgb, linear };

class View {
 public:
  struct Settings {
    ViewTransform transform = ViewTransform::filmic;
  };
  struct In {
    frame::TextureId picture;  ///< RGBA16F, one sample
  };
  struct Out {
    frame::TextureId display;  ///< RGBA8, copied from afterwards
  };
  explicit View(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  frame::TextureId display_;
  const gpu::Pipeline* pipeline_ = nullptr;
  VkSampler sampler_ = VK_NULL_HANDLE;
};

/// Averages the samples of a multisampled target.
class Resolve {
 public:
  struct Settings {};
  struct In {
    frame::TextureId picture;  ///< more than one sample
  };
  struct Out {
    frame::TextureId picture;  ///< one sample
  };
  explicit Resolve(const Settings&) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary&) {}
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const;

 private:
  In in_;
  frame::TextureId target_;
};

}  // namespace dermis::passes
