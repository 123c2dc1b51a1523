// SPDX-License-Identifier: MIT
/// Passes that spread the light of an object: masks of unlit texels, seams, one axis of a Gaussian, and light
/// through the body that joins. Based on: [DLE07] sec. 3.3; [JG08] sec. 3
#pragma once

#include "render/passes/compute_pass.h"
#include "render/techniques/published/kernels.h"
#include "render/techniques/published/object.h"

namespace dermis::techniques::papers {

/// Refreshes the texels beside seams: seams.comp, with the list that head/scene/surface/gutters.h makes.
class Seams : public passes::ComputePass {
 public:
  struct Settings {
    Object object;
    bool of_stretch = false;  ///< `target` is a stretch map, which is made once
  } settings;
  struct In {
    frame::TextureId target;  ///< changed in place
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Marks the texels that hold light in a depth buffer: depth_mask.frag.
class DepthMask {
 public:
  struct Settings {
    Object object;
  } settings;
  struct In {
    frame::TextureId light, mask;  ///< mask: D32
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipeline_ = nullptr;
};

/// One axis of one step: blur.frag.
class Blur {
 public:
  struct Settings {
    Object object;
    double variance_mm2 = 0;  ///< of the step
    bool first = false;       ///< its light is that of whole texels
    std::uint32_t axis = 0;   ///< 0, then 1
    bool alpha_test = false;  ///< unlit texels are skipped by their alpha
  } settings;
  struct In {
    frame::TextureId light, stretch, target;
    frame::TextureId depth_mask;  ///< valid: it skips unlit texels
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipeline_ = nullptr;
  gpu::Buffer kernels_;
};

/// Adds light through the body to what has spread: through.comp.
class JoinThrough : public passes::ComputePass {
 public:
  struct Settings {
    Object object;
  } settings;
  struct In {
    frame::TextureId light;    ///< after the step before
    frame::TextureId through;  ///< changed in place to the sum
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::techniques::papers
