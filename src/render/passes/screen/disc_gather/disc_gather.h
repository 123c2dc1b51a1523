// SPDX-License-Identifier: MIT
/// Gathers the light of the skin from a disc around each pixel, weighted by the profile at the distance in
/// space: one pass, the same pattern of taps everywhere. Based on: [CB15] Christensen, Burley: Approximate
/// Reflectance Profiles for Efficient Subsurface Scattering. Pixar TM
///        15-04, 2015
/// [XOK20] Xie, Olano, Karis, Narkowicz: Real-time subsurface scattering with single pass variance-guided
///         adaptive importance sampling. I3D 2020 (the class of techniques; neither their adaptive number of
///         taps nor their history; Unreal Engine, whose weights `ue` takes, has it)
#pragma once

#include <vector>

#include "render/passes/compute_pass.h"
#include "render/passes/screen/screen_surface.h"
#include "tissue/gaussians/screen_kernels.h"

namespace dermis::passes {

/// The disc of a skin mesh.
struct Disc {
  std::vector<gaussians::DiscTap> taps;  ///< as many for every mesh
  ScatterProfile profile;                ///< used unless normalised diffusion is
  gaussians::Rgb burley_mm{};            ///< d of normalised diffusion, > 0
  double reach_mm = 1;                   ///< the radius that holds 99.7 % of the light
  double mm_per_unit = 1000;             ///< mm of the asset per metre of the world
};

class DiscGather : public ComputePass {
 public:
  struct Settings {
    std::vector<Disc> discs;  ///< one per skin mesh of the plan
    bool burley = false;      ///< normalised diffusion in place of the profile
    /// Taps begin a pixel from the middle, which has the share of the light within; they weigh by r R(r), and
    /// by how their normals agree.
    bool ue = false;
  } settings;
  struct In {
    ScreenSurface surface;
  } in;
  struct Out {
    frame::TextureId light;  ///< as ScreenSurface::light
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  gpu::Buffer profiles_, taps_, radii_;  // radii_: with `ue`
  Out out_;
};

}  // namespace dermis::passes
