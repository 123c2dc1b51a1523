// SPDX-License-Identifier: MIT
/// Answer of the skin of one mesh of one head to light at a pixel: the weighted sum of the blurred light,
/// albedo, two-lobe specular. With no terms it is the Lambert model with the same light and energy. Common
/// part of the passes that shade entries. Based on: [DLE07] sec. 3.4 and GPU Gems 3, ch. 14.4.6
#pragma once

#include <bitset>
#include <optional>
#include <vector>

#include "render/passes/light_map/light_pool.h"
#include "render/passes/light_map/lighting.h"
#include "render/passes/light_map/mapped_terms.h"
#include "render/passes/light_map/transmission.h"
#include "render/passes/pixels/shade/shade_io.h"

namespace dermis::passes {

/// Properties of a material that decide which code draws its skin: a number below `count`.
struct SkinKind {
  bool cut_out = false, emits = false, detailed = false;
  static constexpr std::size_t count = 8;
  constexpr std::size_t index() const { return 4 * std::size_t{cut_out} + 2 * std::size_t{emits} + detailed; }
};

/// The skin of one mesh, as the plan knows it.
struct SkinLook {
  MapSquare square;
  /// Those that maps hold, narrow to wide, 0 to 8; none = Lambert. The rest of the weights to 1 is lit at the
  /// pixel.
  std::vector<MapTerm> terms;
  bool reads_entered() const { return !terms.empty() && terms.back().sigma_mm == 0; }
  bool environment = false;   ///< light from FrameData::environment, else FrameIo::ambient
  bool soft_shadows = false;  ///< lights with a radius cast penumbrae
  std::uint32_t samples = 1;  ///< of the ids
  /// 1 or 2: points at which an entry is shaded that covers its pixel
  std::uint32_t light_samples = 2;
  /// some triangles have no chart of the unwrap: they are lit per pixel, without scattering
  bool off_map = false;
  std::bitset<SkinKind::count> kinds = 1;  ///< of the mesh's skin, by index()
  /// terms that MappedTerms leaves out are lit at the pixel, and those for which the map has too few texels:
  /// map_share()
  bool mixes = false;
  /// some light leaves where it entered, for which the weights leave room: it is lit per pixel
  bool unscattered = false;
  /// in mm of the asset; none: light leaves as from a flat half-space
  std::optional<ShapeLaws> shape;
  double mm_per_unit = 1000;  ///< mm of the asset per metre of the world
  /// The profile, if there is transmitted light, also for the part lit per pixel. See Irradiance.
  std::optional<ThroughMesh> through;
};

/// The light that it reads.
struct SkinLights {
  std::vector<frame::TextureId> maps;  ///< RGBA16F pools, one per term
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

/// Bindings and variants of the shaders of these passes.
class SkinShading {
 public:
  SkinShading() = default;
  SkinShading(SkinLook look, SkinLights lights);
  void declare(frame::Declare& d) const;
  void prepare(gpu::PipelineLibrary& library);

  /// Returns the variants that some frame needs.
  std::vector<SkinVariant> variants() const;
  SkinVariant variant_of(const FrameData& frame, const GpuDraw& draw, const GpuMaterial& material) const;
  /// Returns whether the variant knows transmitted light: its shaders have names of their own.
  bool through(const SkinVariant& variant) const;
  /// Returns the constants of shaders that read light maps.
  gpu::Constants constants(const SkinVariant& variant) const;
  /// Returns those that every shader of entries has.
  gpu::Constants entry_constants(const SkinVariant& variant) const;

  /// Offers all but what draw_skin() does.
  void offer(Bindings& bindings, const frame::Resources& resources, const FrameData& frame) const;
  /// Returns what holds for all parts of the mesh; shade_parts() fills in the rest.
  io::ShadeIo io(const FrameData& frame) const;

 private:
  SkinVariant::Lit lit_of(const FrameData& frame) const;
  /// Of skin of which some term is read from a map.
  SkinVariant::Lit lit_by_maps() const {
    return look_.mixes || look_.unscattered ? SkinVariant::Lit::mixed : SkinVariant::Lit::on_map;
  }
  bool through() const { return look_.through && (look_.mixes || look_.off_map || look_.terms.empty()); }
  void offer_maps(Bindings& bindings, const frame::Resources& resources, const Head& head) const;

  SkinLook look_;
  SkinLights lights_;
  LightingSamplers samplers_;
  ThroughBindings through_;
  gpu::Buffer terms_;
};

}  // namespace dermis::passes
