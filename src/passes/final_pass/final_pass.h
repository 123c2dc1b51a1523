// SPDX-License-Identifier: MIT
/// The head on the screen: the weighted sum of the blurred light, albedo, two-lobe specular.
/// Based on: [DLE07] sec. 3.4 and GPU Gems 3, ch. 14.4.6. With no terms it is the Lambert model with the same
/// light and energy.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "passes/final_pass/final_pass_io.h"
#include "passes/light_pool.h"
#include "passes/lighting.h"
#include "passes/transmission.h"

namespace dermis::passes {

/// How much of a term is lit at the pixel instead of read from the map, 0..1. A map at less than T_max holds
/// light at about a texel per pixel: it cannot hold what a Gaussian narrower than its texels leaves sharp,
/// while that Gaussian does not show at the pixel. Departs from [JG08] sec. 4, where all is read from the
/// small map; changes smoothly with T so that nothing pops, and is 0 at T_max.
float direct_share(float sigma_texels, float shrink);

/// How much of a term is lit at the pixel because the map, at T_max, has too few texels at this place, 0..1.
/// Texels spread light by half their side (box and bilinear tent: a variance of a quarter), so a Gaussian of
/// less than 0.29 texels is nearer to what it shows without the map than with it: the share falls from 1 at
/// 0.2 to 0 at 0.4 texels. That counts where the map is poor: where this place has less than 0.15 (fully
/// 0.075) times as many texels per mm as if the skin filled the map evenly, or where not even the widest
/// Gaussian is as many texels wide. Whole heads have more: the poorest twentieth of the scan has 0.21 times.
/// Elsewhere all is read from the map, as published, however few texels the user wants.
float coarse_share(float sigma_mm, float widest_mm, float texels_per_mm, float even_texels_per_mm);

/// Whether coarse_share() of some term is over 0 there.
bool is_coarse(float widest_mm, float texels_per_mm, float even_texels_per_mm);

/// The terms of a profile on the light map of a mesh.
struct TermsOnMap {
  std::vector<float> sigmas_mm;    ///< a term each, narrow to wide
  float even_texels_per_mm = 1;    ///< of a map of one texel, if the skin filled it evenly
  std::uint32_t largest_side = 0;  ///< T_max
  bool coarse = false;             ///< see coarse_share(); decided per pixel where it is set
};

class FinalPass {
 public:
  struct Settings {
    MapSquare square;                           ///< not halved
    std::uint32_t samples = 1;                  ///< of the targets
    bool clear = false;                         ///< the first to draw into them
    std::vector<std::array<float, 3>> weights;  ///< a term each, 0 to 8; none = Lambert
    std::vector<std::uint32_t> halvings;        ///< of the term's map, a term each; the first is 0
    bool environment = false;                   ///< light from FrameData::environment, else FrameIo::ambient
    bool soft_shadows = false;                  ///< lights with a radius cast penumbrae
    /// some triangles have no chart of the unwrap: all their light is lit at the pixel, nothing scatters
    bool off_map = false;
    bool cut_out = false;  ///< some of the mesh's skin is cut out by its alpha
    bool emits = false;    ///< some of the mesh's skin emits light
    /// where the map is smaller than T_max, narrow terms are lit per pixel: see direct_share()
    bool mixes = false;
    TermsOnMap terms;
    float texels_per_mm = 0;  ///< mean of the unwrap, at T_max
    /// The profile, if light comes through the body: of what is lit at the pixel, too. See Irradiance.
    std::optional<gaussians::SumOfGaussians> through;
    double mm_per_unit = 1000;  ///< of the scene
  } settings;
  struct In {
    std::vector<frame::TextureId> lights;  ///< RGBA16F pools, a term each
    frame::TextureId shadow, colour, depth;
    frame::TextureId entering = {};  ///< with `through` and `mixes`: as in Irradiance
  } in;
  struct Out {
    frame::TextureId colour, depth;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  // Ordinary skin is drawn by shaders that know neither alpha test nor emission.
  struct Pipelines {
    const gpu::Pipeline* made[2][2][2] = {};  // [double sided][cut out][emits]
    const gpu::Pipeline* of(const GpuMaterial& m) const { return made[m.double_sided][m.cut_out][m.emits]; }
  };
  enum class Lit : std::uint8_t { on_map, mixed, at_pixel };
  Pipelines make_pipelines(gpu::PipelineLibrary& library, Lit lit, bool off_map) const;
  const Pipelines& pipelines_of(const GpuDraw& draw, bool mixed) const;
  void offer_light(Bindings& bindings, const frame::Resources& resources, const FrameData& frame) const;
  float share_at_pixel(std::size_t term, const Instance& instance) const;
  io::FinalPassIo final_io(const FrameData& frame) const;
  Pipelines mapped_, mixed_;  // all terms from the maps; some of their light at the pixel
  Pipelines off_map_;         // of triangles without a chart
  bool through() const {
    return settings.through && (settings.mixes || settings.off_map || settings.terms.coarse);
  }
  LightingSamplers samplers_;
  ThroughBindings through_;
  gpu::Buffer terms_;  // SkinTermsIo
};

/// Counts, over the fragments of the final pass that are seen, those whose bilinear read weighs a texel that
/// was never lit. Stands right behind FinalPass with the same square; runs for statistics.
class UnshadedReads {
 public:
  struct Settings {
    MapSquare square;
    std::uint32_t samples = 1;
    bool cut_out = false;    ///< as of FinalPass
    std::uint32_t slot = 0;  ///< of the counters
    TermsOnMap terms;        ///< as of FinalPass
  } settings;
  struct In {
    frame::TextureId light, depth;
    frame::BufferId counters;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipelines_[2][2] = {};  // [double sided][cut out]
  gpu::Buffer terms_;                          // SkinTermsIo
};

/// The uniform buffer that both passes bind as "Terms".
gpu::Buffer make_terms(gpu::Device& device, const TermsOnMap& terms);

}  // namespace dermis::passes
