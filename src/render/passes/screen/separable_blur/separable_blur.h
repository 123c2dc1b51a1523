// SPDX-License-Identifier: MIT
/// Blurs the light of the skin along one axis of the picture, by a kernel of one dimension per skin mesh: two
/// such passes are separable scattering.
/// Based on: [JZJ15] Jimenez, Zsolnai, Jarabo et al.: Separable Subsurface Scattering. CGF 34(6), 2015
#pragma once

#include <vector>

#include "render/passes/compute_pass.h"
#include "render/passes/screen/screen_surface.h"
#include "tissue/gaussians/screen_kernels.h"

namespace dermis::passes {

/// The kernel of a skin mesh.
struct LineKernel {
  std::vector<gaussians::LineTap> taps;  ///< the middle first; as many for every mesh
  double mm_per_unit = 1000;             ///< mm of the asset per metre of the world
  double reach_mm = 1;                   ///< of the outer taps
};

class SeparableBlur : public ComputePass {
 public:
  struct Settings {
    std::vector<LineKernel> kernels;  ///< one per skin mesh of the plan
    /// 0: along the rows of the picture. 1: along the direction that is perpendicular to them on the skin, or
    /// with `published` in the picture.
    std::uint32_t axis = 0;
    /// The authors' own steps and their rule that follows the surface, else mm on the tangent plane.
    bool published = false;
  } settings;
  struct In {
    frame::TextureId light;  ///< as ScreenSurface::light
    ScreenSurface surface;
  } in;
  struct Out {
    frame::TextureId light;  ///< likewise
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  gpu::Buffer kernels_, taps_;
  Out out_;
};

}  // namespace dermis::passes
