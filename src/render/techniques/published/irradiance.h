// SPDX-License-Identifier: MIT
/// Rasters the light that enters the skin, in texture coordinates. Based on: [DLE07] sec. 3.2. Texels that
/// are not lit: [JG08] sec. 3 (cull), 4 (only T x T texels), 5 (clip)
#pragma once

#include <array>
#include <vector>

#include "render/passes/light_map/lighting.h"
#include "render/passes/light_map/transmission.h"
#include "render/techniques/published/object.h"

namespace dermis::techniques::papers {

/// Skin and light of both passes of this file.
struct LitMesh {
  Object object;
  bool clip = false;          ///< leaves out skin outside the picture and its margin
  bool cut_out = false;       ///< some material has an alpha test
  bool environment = false;   ///< light from FrameData::environment, else FrameIo::ambient
  bool soft_shadows = false;  ///< lights with a radius cast penumbrae
  /// The profile, if light comes through the body: translucent shadow maps.
  std::optional<passes::ThroughMesh> through;
  frame::TextureId shadow;
  frame::TextureId entering;  ///< with `through`; not valid: all light enters
  frame::BufferId kept;       ///< indices of the triangles that are drawn; not valid: all
};

class Irradiance {
 public:
  struct Settings {
    LitMesh mesh;
  } settings;
  struct In {
    frame::TextureId light;  ///< RGBA16F, T_max x T_max; the used square is cleared here
    /// With `through`: the light that joins at the second and the third group of terms, as many as there are.
    std::vector<frame::TextureId> joining;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  std::array<const gpu::Pipeline*, 2> pipelines_{};  // [cut out]
  passes::ThroughBindings through_;
  passes::LightingSamplers samplers_;
};

/// Counts what transmitted light did not find, for the statistics: missed_light.frag. Follows Irradiance.
class MissedLight {
 public:
  struct Settings {
    LitMesh mesh;
    std::uint32_t slot = 0;  ///< of the counters
  } settings;
  struct In {
    frame::BufferId counters;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipeline_ = nullptr;
  passes::ThroughBindings through_;
  passes::LightingSamplers samplers_;
};

}  // namespace dermis::techniques::papers
