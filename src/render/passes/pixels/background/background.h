// SPDX-License-Identifier: MIT
/// Adds what stands behind the heads.
#pragma once

#include "render/passes/compute_pass.h"
#include "render/passes/frame_data.h"
#include "render/passes/pixels/behind.h"

namespace dermis::passes {

class Background : public ComputePass {
 public:
  struct Settings {
    Behind behind;  ///< light
  } settings;
  struct In {
    frame::TextureId picture;  ///< RGBA16F, one sample, black where nothing is
    frame::TextureId open;     ///< of OpenShare
  } in;
  struct Out {
    frame::TextureId picture;  ///< as that of In, alpha too
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
  void prepare(gpu::PipelineLibrary& library);

 private:
  VkSampler around_ = VK_NULL_HANDLE;
  Out out_;
};

}  // namespace dermis::passes
