// SPDX-License-Identifier: MIT
/// How the skin of one mesh of one head answers light at a pixel: the weighted sum of the blurred light,
/// albedo, two-lobe specular. With no terms it is the Lambert model with the same light and energy. Common
/// part of FinalPass, which draws it, and Shade, which computes it.
/// Based on: [DLE07] sec. 3.4 and GPU Gems 3, ch. 14.4.6
#pragma once

#include <array>
#include <bitset>
#include <optional>
#include <vector>

#include "passes/final_pass/final_pass_io.h"
#include "passes/light_pool.h"
#include "passes/lighting.h"
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
  /// in mm of the asset; none: light leaves as from a flat half-space
  std::optional<ShapeLaws> shape;
  double mm_per_unit = 1000;  ///< mm of the asset per metre of the world
};

/// What of a material decides which code draws its skin: a number below `count`.
struct SkinKind {
  bool cut_out = false, emits = false, detailed = false;
  static constexpr std::size_t count = 8;
  constexpr std::size_t index() const { return 4 * std::size_t{cut_out} + 2 * std::size_t{emits} + detailed; }
};

/// What the plan knows of the skin of one mesh.
struct SkinLook {
  MapSquare square;                           ///< not halved
  std::vector<std::array<float, 3>> weights;  ///< one per term, 0 to 8; none = Lambert
  /// One map holds the sum of all terms, already weighted (with MappedTerms::weights): the only one.
  bool summed = false;
  bool environment = false;   ///< light from FrameData::environment, else FrameIo::ambient
  bool soft_shadows = false;  ///< lights with a radius cast penumbrae
  /// some triangles have no chart of the unwrap: they are lit per pixel, without scattering
  bool off_map = false;
  std::bitset<SkinKind::count> kinds = 1;  ///< of the mesh's skin, by index()
  /// where the map is smaller than T_max, narrow terms are lit per pixel: see direct_share()
  bool mixes = false;
  /// some light leaves where it entered, for which the weights leave room: it is lit per pixel
  bool unscattered = false;
  TermsOnMap terms;
  float texels_per_mm = 0;  ///< mean of the unwrap, at T_max
  /// The profile, if there is transmitted light, also for the part lit per pixel. See Irradiance.
  std::optional<ThroughMesh> through;
};

/// The light that it reads.
struct SkinLights {
  std::vector<frame::TextureId> maps;  ///< RGBA16F pools, one per term, or with `summed` one
  frame::TextureId shadow;
  frame::TextureId entering = {};  ///< with `through`, where terms are lit per pixel: as in Irradiance
};

/// A variant of the shaders: how a draw is lit, and whether ordinary skin is all it needs to know.
struct SkinVariant {
  enum class Lit : std::uint8_t { on_map, mixed, at_pixel };
  Lit lit = Lit::on_map;
  bool off_map = false;
  SkinKind kind;
  static constexpr std::size_t count = 6 * SkinKind::count;
  std::size_t index() const {
    return SkinKind::count * (2 * static_cast<std::size_t>(lit) + std::size_t{off_map}) + kind.index();
  }
};

/// What both passes offer to their shaders.
class SkinShading {
 public:
  SkinShading() = default;
  SkinShading(SkinLook look, SkinLights lights);
  void declare(frame::Declare& d) const;
  void prepare(gpu::PipelineLibrary& library);

  /// Returns the variants that some frame needs.
  std::vector<SkinVariant> variants() const;
  SkinVariant variant_of(const Instance& instance, const GpuDraw& draw, const GpuMaterial& material) const;
  /// Returns whether the variant knows transmitted light: its shaders have names of their own.
  bool through(const SkinVariant& variant) const;
  gpu::Constants constants(const SkinVariant& variant) const;
  /// Adds those that shaders with transmitted light have beside.
  void add_through_constants(gpu::Constants& constants) const;

  /// Offers all but what draw_skin() does.
  void offer(Bindings& bindings, const frame::Resources& resources, const FrameData& frame) const;
  io::FinalPassIo io(const FrameData& frame) const;

 private:
  float share_of(std::size_t term, const Instance& instance) const;
  SkinVariant::Lit lit_of(const Instance& instance) const;
  bool through() const {
    return look_.through && (look_.mixes || look_.off_map || look_.terms.coarse || look_.weights.empty());
  }
  void offer_maps(Bindings& bindings, const frame::Resources& resources, const Instance& instance) const;

  SkinLook look_;
  SkinLights lights_;
  LightingSamplers samplers_;
  ThroughBindings through_;
  gpu::Buffer terms_;
};

/// Returns the uniform buffer that shaders bind as "Terms": ThroughTermsIo, of which the first part is all
/// that shaders without transmitted light declare.
gpu::Buffer make_terms(gpu::Device& device, const TermsOnMap& terms,
                       const std::optional<ThroughMesh>& through = std::nullopt);

}  // namespace dermis::passes
