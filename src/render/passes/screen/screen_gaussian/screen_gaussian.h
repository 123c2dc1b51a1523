// SPDX-License-Identifier: MIT
/// Blurs the light of the skin along one axis by one Gaussian of a chain, and adds the result to their
/// weighted sum: two such passes per Gaussian. Chains go from narrow to wide, each step by what its variance
/// has more. Based on: [JSG09] of tissue/gaussians/screen_kernels.h
#pragma once

#include <vector>

#include "render/passes/compute_pass.h"
#include "render/passes/screen/screen_surface.h"
#include "tissue/gaussians/sum.h"

namespace dermis::passes {

/// One Gaussian of the chain of a skin mesh.
struct GaussianStep {
  double variance_mm2 = 0;    ///< of this step; 0: light stays as it is
  gaussians::Rgb weight{};    ///< of the blurred light in the sum
  double mm_per_unit = 1000;  ///< mm of the asset per metre of the world
  double reach_mm = 1;        ///< light does not go where skin is as far off the tangent plane
};

class ScreenGaussian : public ComputePass {
 public:
  struct Settings {
    std::vector<GaussianStep> steps;  ///< one per skin mesh of the plan
    /// 0, the first: across the rows, where that is perpendicular to them on the skin; 1: along the rows,
    /// after which the light is added to the sum. With `published` along the columns and rows of the picture.
    std::uint32_t axis = 0;
    int radius = 6;          ///< taps on either side, 1 to kernel_radius
    bool published = false;  ///< the authors' own seven taps and their rule for the width
    bool begins = false;     ///< it is the first Gaussian of the sum
  } settings;
  struct In {
    frame::TextureId light;   ///< as ScreenSurface::light
    frame::TextureId target;  ///< likewise, another one
    frame::TextureId sum;     ///< likewise; of axis 1
    ScreenSurface surface;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  gpu::Buffer steps_, kernels_;
};

}  // namespace dermis::passes
