// SPDX-License-Identifier: MIT
/// Lights the texels of heads' light maps: the light that enters the skin there.
/// Based on: [DLE07] sec. 3.2; [BL03] Borshukov, Lewis: Realistic Human Face Rendering for "The Matrix
/// Reloaded", 2003. Texels that are not shaded: [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin,
/// CEIG 2008, sec. 3 (cull), 4 (the used square), 5 (clip)
#pragma once

#include <array>
#include <string>
#include <vector>

#include "render/passes/light_map/light_pool.h"
#include "render/passes/light_map/lighting.h"
#include "render/passes/light_map/tile_lists.h"
#include "render/passes/light_map/transmission.h"
#include "tissue/gaussians/sum.h"

namespace dermis::passes {

/// A pipeline for each kind of material and each profile, with what it is given: shared by the passes over
/// lit texels.
class LitTexels {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    bool environment = false;   ///< light from FrameData::environment, else FrameIo::ambient
    bool soft_shadows = false;  ///< lights with a radius cast penumbrae
    bool cut_out = false;       ///< leaves out what the alpha test of some material cuts away
    bool from_host = false;     ///< the light is what a host has drawn, see HostIrradiance
    /// For transmitted light (render/passes/light_map/transmission.h): the profiles of the skin meshes in
    /// `squares`, of 1 to 8 terms. Empty: no transmitted light.
    std::vector<ThroughMesh> through;
  };
  struct In {
    frame::TextureId shadow;         ///< of these heads
    frame::TextureId entering = {};  ///< with `through`: see Shadow; not valid: all light enters
    frame::TextureId texels;         ///< of TexelMap
    TileLists lists;                 ///< the lit tiles
  };
  static void declare(frame::Declare& d, const Settings& settings, const In& in);
  /// `shader`: of the folder of this file. `constants`: of all pipelines.
  void prepare(gpu::PipelineLibrary& library, const std::string& shader, const Settings& settings,
               const In& in, gpu::Constants constants);
  /// Dispatches over the squares that the frame uses. `of_pass`: bindings beside those of the texels, the
  /// scene and its light.
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
              const Settings& settings, const In& in, const Bindings& of_pass) const;

 private:
  // [cut out]: one each, or with `through` one for each of its entries
  std::array<std::vector<const gpu::Pipeline*>, 2> pipelines_;
  ThroughBindings through_;
  LightingSamplers samplers_;
};

/// Lights the lit tiles; leaves what no triangle covers as it is.
class Irradiance {
 public:
  LitTexels::Settings settings;
  using Settings = LitTexels::Settings;
  struct In {
    frame::TextureId light;  ///< RGBA16F pool, 0 in the used squares
    /// With `through`: likewise, for the light without what comes through the body; not valid: not stored.
    frame::TextureId entered = {};
    LitTexels::In texels;
    /// With `through`: RGBA16F pools, likewise 0, for the light that joins at the second and the third group
    /// of terms, as many as the mesh with most groups needs.
    std::vector<frame::TextureId> joining = {};
    frame::TextureId host_irradiance = {};  ///< with `from_host`
  } in;
  struct Out {
    frame::TextureId light;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  LitTexels lit_;
};

/// Counts, over the texels that Irradiance lights, reads of transmitted light that found nothing, for the
/// statistics. Has the same settings, with `through` not empty.
class TransmissionMisses {
 public:
  struct Settings {
    LitTexels::Settings irradiance;
    std::uint32_t slot = 0;  ///< of the counters
  } settings;
  struct In {
    LitTexels::In texels;
    frame::BufferId counters;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  LitTexels lit_;
};

}  // namespace dermis::passes
