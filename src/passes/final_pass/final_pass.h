// SPDX-License-Identifier: MIT
/// Draws the head on the screen: the weighted sum of the blurred light, albedo, two-lobe specular. With no
///   terms it is the
/// Lambert model with the same light and energy.
/// Based on: [DLE07] sec. 3.4 and GPU Gems 3, ch. 14.4.6
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "passes/final_pass/final_pass_io.h"
#include "passes/light_pool.h"
#include "passes/lighting.h"
#include "passes/targets.h"
#include "passes/transmission.h"

namespace dermis::passes {

/// Returns the part of a term, 0..1, that is lit per pixel instead of read from the map. A map smaller than
/// T_max has about one texel per pixel: it cannot hold detail that a Gaussian narrower than its texels leaves
/// sharp, while that Gaussian is not visible at the pixel. Departs from [JG08] sec. 4, which reads all from
/// the small map. Changes smoothly with T, so that nothing pops, and is 0 at T_max.
float direct_share(float sigma_texels, float shrink);
/// Returns it for a Gaussian of this width on a map of `side` texels per side (T). texels_per_mm: the mean of
/// the unwrap on a map of `largest_side` (T_max).
float share_at_pixel(float sigma_mm, float texels_per_mm, std::uint32_t largest_side, std::uint32_t side);

/// Returns the part of a term, 0..1, that is lit per pixel because the map, at T_max, has too few texels
/// here. Texels spread light by half their side (box and bilinear tent: a variance of a quarter), so a
/// Gaussian of less than 0.29 texels is nearer to its own width without the map: the part falls from 1 at 0.2
/// to 0 at 0.4 texels. Applies only where the map is poor: where this place has less than 0.15 (fully below
/// 0.075) times as many texels per mm as if the skin filled the map evenly, or where even the widest Gaussian
/// is less than as many texels wide. Whole heads have more: the poorest twentieth of the scan has 0.21 times.
/// Elsewhere all is read from the map, as published, however small it is set.
float coarse_share(float sigma_mm, float widest_mm, float texels_per_mm, float even_texels_per_mm);

/// Returns whether coarse_share() of some term is over 0 there.
bool is_coarse(float widest_mm, float texels_per_mm, float even_texels_per_mm);

/// The terms of a profile on the light map of a mesh.
struct TermsOnMap {
  std::vector<float> sigmas_mm;    ///< one per term, narrow to wide
  float even_uv_per_mm = 1;        ///< texture coordinates per mm, if the skin filled the map evenly
  std::uint32_t largest_side = 0;  ///< T_max
  bool coarse = false;             ///< see coarse_share(); if set, decided per pixel
};

class FinalPass {
 public:
  struct Settings {
    MapSquare square;                           ///< not halved
    std::uint32_t samples = 1;                  ///< of the targets
    PictureFormat format;                       ///< of the targets
    bool clear = false;                         ///< this pass is the first to draw into them
    std::vector<std::array<float, 3>> weights;  ///< one per term, 0 to 8; none = Lambert
    std::vector<std::uint32_t> halvings;        ///< of the term's map, one per term; the first is 0
    /// One map holds the sum of all terms, already weighted (with MappedTerms::weights): the only one of
    /// In::lights.
    bool summed = false;
    bool environment = false;   ///< light from FrameData::environment, else FrameIo::ambient
    bool soft_shadows = false;  ///< lights with a radius cast penumbrae
    /// some triangles have no chart of the unwrap: they are lit per pixel, without scattering
    bool off_map = false;
    bool cut_out = false;  ///< some of the mesh's skin is cut out by its alpha
    bool emits = false;    ///< some of the mesh's skin emits light
    /// where the map is smaller than T_max, narrow terms are lit per pixel: see direct_share()
    bool mixes = false;
    TermsOnMap terms;
    float texels_per_mm = 0;  ///< mean of the unwrap, at T_max
    /// The profile, if there is transmitted light, also for the part lit per pixel. See Irradiance.
    std::optional<ThroughMesh> through;
  } settings;
  struct In {
    std::vector<frame::TextureId> lights;  ///< RGBA16F pools, one per term, or with `summed` one
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
  // Ordinary skin has shaders without alpha test and emission.
  struct Pipelines {
    const gpu::Pipeline* made[2][2][2] = {};  // [double sided][cut out][emits]
    const gpu::Pipeline* of(const GpuMaterial& m) const { return made[m.double_sided][m.cut_out][m.emits]; }
  };
  enum class Lit : std::uint8_t { on_map, mixed, at_pixel };
  Pipelines make_pipelines(gpu::PipelineLibrary& library, Lit lit, bool off_map) const;
  const Pipelines& pipelines_of(const GpuDraw& draw, Lit lit) const;
  Lit lit_of(const Instance& instance) const;
  void offer_light(Bindings& bindings, const frame::Resources& resources, const Instance& instance) const;
  float share_of(std::size_t term, const Instance& instance) const;
  io::FinalPassIo final_io(const FrameData& frame) const;
  Pipelines mapped_, mixed_;  // all terms from the maps; some of their light per pixel
  Pipelines at_pixel_;        // no term from the maps
  Pipelines off_map_;         // of triangles without a chart
  bool through() const {
    return settings.through && (settings.mixes || settings.off_map || settings.terms.coarse);
  }
  LightingSamplers samplers_;
  ThroughBindings through_;
  gpu::Buffer terms_;  // SkinTermsIo
};

/// Counts the visible fragments of the final pass whose bilinear read weighs a texel that was never lit, for
/// the statistics. Directly follows FinalPass with the same square.
class UnshadedReads {
 public:
  struct Settings {
    MapSquare square;
    std::uint32_t samples = 1;
    bool cut_out = false;          ///< as of FinalPass
    std::uint32_t slot = 0;        ///< of the counters
    TermsOnMap terms;              ///< as of FinalPass
    std::uint32_t first_term = 0;  ///< that of the first of `lights`
  } settings;
  struct In {
    std::vector<frame::TextureId>
        lights;  ///< RGBA16F pools of one size, one per term; reads the first that is read
    frame::TextureId depth;
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

/// Returns the uniform buffer that both passes bind as "Terms".
gpu::Buffer make_terms(gpu::Device& device, const TermsOnMap& terms);

}  // namespace dermis::passes
