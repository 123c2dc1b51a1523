// SPDX-License-Identifier: MIT
/// Irradiance without drawing: each listed texel of a light map computes its light, for the triangle that a
/// map of texels names.
#pragma once

#include <array>
#include <vector>

#include "passes/irradiance/irradiance.h"
#include "passes/texel_lists.h"

namespace dermis::passes {

/// Which texels are lit, and what they show.
struct LitTexels {
  frame::TextureId map;  ///< of TexelMap
  TexelLists lists;      ///< of these squares, with their ranges
  bool valid() const { return map.valid(); }
};

/// A pipeline for each kind of material and each profile, and what they are given: shared by the passes over
/// texels.
class TexelPipelines {
 public:
  /// `shader`: of the folder of this file. `constants`: of all pipelines.
  void prepare(gpu::PipelineLibrary& library, const std::string& shader, const Irradiance::Settings& settings,
               const gpu::Constants& constants);
  /// Dispatches over the squares that the frame uses. `of_pass`: bindings beside those of the texels, the
  /// scene and its light.
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
              const Irradiance::Settings& settings, const Irradiance::In& in, const LitTexels& texels,
              const Bindings& of_pass) const;

  // [cut out]: one each, or with `through` one for each of its entries
  std::array<std::vector<const gpu::Pipeline*>, 2> pipelines_;
  ThroughBindings through_;
  LightingSamplers samplers_;
};

/// As Irradiance, in a compute pass. Of two triangles that share texels the last one that is kept owns them,
/// whether or not it is cut away. Needs `from_host` to be false.
class IrradianceTexels {
 public:
  struct Settings {
    Irradiance::Settings irradiance;
  } settings;
  struct In {
    Irradiance::In irradiance;  ///< cleared by ClearTexels
    LitTexels texels;
  } in;
  using Out = Irradiance::Out;
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  TexelPipelines pipelines_;
};

/// As TransmissionMisses, over the texels that IrradianceTexels lights.
class TransmissionMissesOfTexels {
 public:
  struct Settings {
    Irradiance::Settings irradiance;
    std::uint32_t slot = 0;  ///< of the counters
  } settings;
  struct In {
    Irradiance::In irradiance;
    LitTexels texels;
    frame::BufferId counters;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  TexelPipelines pipelines_;
};

}  // namespace dermis::passes
