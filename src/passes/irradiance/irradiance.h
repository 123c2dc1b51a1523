// SPDX-License-Identifier: MIT
/// Draws heads in their texture coordinates: the light that enters the skin, per texel.
/// Based on: [DLE07] sec. 3.2; [BL03] Borshukov, Lewis: Realistic Human Face Rendering for "The Matrix
///   Reloaded", 2003.
/// What is not shaded: [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin, CEIG 2008, sec. 3 (cull), 4
///   (the used
/// square), 5 (clip)
#pragma once

#include <array>

#include "gaussians/sum.h"
#include "passes/kept_triangles.h"
#include "passes/light_pool.h"
#include "passes/lighting.h"
#include "passes/transmission.h"

namespace dermis::passes {

class Irradiance {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    bool environment = false;   ///< light from FrameData::environment, else FrameIo::ambient
    bool soft_shadows = false;  ///< lights with a radius cast penumbrae
    bool clip = false;          ///< leaves out skin outside the picture and its margin
    bool cut_out = false;       ///< leaves out what the alpha test of some material cuts away
    bool from_host = false;     ///< the light is what a host has drawn, see HostIrradiance
    /// For transmitted light (passes/transmission.h): the profiles of the skin meshes in `squares`, of 1 to 8
    /// terms. Empty: no transmitted light.
    std::vector<ThroughMesh> through;
  } settings;
  struct In {
    frame::TextureId light;          ///< RGBA16F pool; the used squares are cleared here
    frame::TextureId shadow;         ///< of these instances
    frame::TextureId entering = {};  ///< with `through`: see Shadow; not valid: all light enters
    /// With `through`: RGBA16F pools for the light that joins at the second and the third group of terms, as
    /// many as the mesh with most groups needs.
    std::vector<frame::TextureId> joining = {};
    frame::TextureId host_irradiance = {};  ///< with `from_host`
    KeptTriangles kept = {};                ///< only these are drawn; not valid: all
  } in;
  struct Out {
    frame::TextureId light;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  // [cut out]: one each, or with `through` one for each of its entries
  std::array<std::vector<const gpu::Pipeline*>, 2> pipelines_;
  ThroughBindings through_;
  LightingSamplers samplers_;
};

/// Counts, over the texels that Irradiance shades, reads of transmitted light that found nothing, for the
/// statistics: see transmission_misses.frag. Follows Irradiance with the same settings, with `through` not
/// empty.
class TransmissionMisses {
 public:
  struct Settings {
    Irradiance::Settings irradiance;
    std::uint32_t slot = 0;  ///< of the counters
  } settings;
  struct In {
    frame::TextureId shadow, entering;
    KeptTriangles kept;  ///< as Irradiance
    frame::BufferId counters;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  std::vector<const gpu::Pipeline*> pipelines_;  // one for each entry of `through`
  ThroughBindings through_;
  LightingSamplers samplers_;
};

}  // namespace dermis::passes
