// SPDX-License-Identifier: MIT
/// How passes make a picture. A technique is a function that adds passes to a plan; the list in all.cpp is
/// the only register.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dermis/settings.h"
#include "frame/graph.h"
#include "gaussians/sum.h"
#include "passes/frame_data.h"
#include "passes/light_pool.h"

namespace dermis::techniques {

/// One skin mesh as the plan needs to know it.
struct SkinPart {
  gaussians::SumOfGaussians profile;
  double max_texels_per_mm = 1;   ///< where its unwrap is densest, at the map size of the frame
  double mean_texels_per_mm = 1;  ///< of its unwrap, at the same size
  /// max_texels_per_mm of a map of one texel
  double densest_texels_per_mm_of_one = 1;
  /// of a map of one texel, if the skin filled it evenly; and whether parts of it have so few that terms are
  /// lit at the pixel there: passes::coarse_share
  double even_texels_per_mm = 1;
  double least_texels_per_mm = 1;  ///< a twentieth of the skin has fewer, at the map size of the frame
  bool coarse = false;
  bool off_map = false;  ///< some of its triangles have no chart of the unwrap
  bool cut_out = false;  ///< some of its materials have an alpha test
  bool emits = false;    ///< some of them emit light
  bool operator==(const SkinPart&) const = default;
};

/// What is not computed because it is not seen. Based on: [JG08] sec. 3 to 5.
struct Optimise {
  bool cull = false;  ///< triangles that face away from the eye
  /// maps as large as the head's distance needs; the plan does not change, Instance::map_side does
  bool depth = false;
  bool clip = false;  ///< what lies outside the picture and a margin
  bool any() const { return cull || depth || clip; }
  bool operator==(const Optimise&) const = default;
};

/// The structure of a frame: a change makes a new plan. What changes per frame is passes::FrameData.
struct FrameSettings {
  std::uint32_t width = 1280, height = 720;
  std::uint32_t samples = 4;         ///< 1 or 4
  std::uint32_t map_size = 2048;     ///< T_max, texels
  std::uint32_t shadow_size = 2048;  ///< texels
  std::uint32_t shadow_layers = 1;   ///< of one head, at least 1
  std::uint32_t heads = 1;
  /// that are lit and blurred together: squares of the pool and sets of shadow maps
  std::uint32_t heads_per_batch = 1;
  /// Skin meshes of a head that are lit and blurred together, 0 = all; fewer only with one head in a batch.
  std::uint32_t meshes_per_batch = 0;
  Optimise optimise;
  /// light comes through the body: lit from behind, thin skin glows
  bool translucency = false;
  /// What casts shadows is skin that takes nothing from light before it scatters (mix 0): no map has to say
  /// what enters.
  bool all_enters = false;
  double mm_per_unit = 1000;  ///< of the scene
  /// alpha, depth or tiles: how convolutions skip what cull and clip have left unlit
  passes::Mask mask = passes::Mask::tiles;
  bool progressive = false;    ///< wide terms are kept in smaller maps, see passes::Downsample
  bool visibility = false;     ///< also makes the map that `--show visibility` shows
  std::vector<SkinPart> skin;  ///< one per skin mesh of the scene
  bool has_surfaces = false, has_blended = false;
  bool environment = false;   ///< light from a picture of the surroundings, else uniform
  bool soft_shadows = false;  ///< some light has a radius
  float bloom = 0;            ///< 0..1
  ToneMap tone_map = ToneMap::natural;
  bool operator==(const FrameSettings&) const = default;
};

/// A map that the settings' `show` can name, and how it becomes a picture.
struct Shown {
  enum class As : std::uint8_t {
    values,        ///< 0 to 1 as they are
    light,         ///< linear light, displayed as sRGB
    depth,         ///< grey: near bright, nothing black
    texel_density  ///< of a stretch map: 0 to 8 texels per mm, from black to white
  };
  frame::TextureId map;
  As as = As::values;
  std::uint32_t layer = 0;
  glm::uvec2 origin{0};      ///< of the rectangle that is shown, texels
  bool used_square = false;  ///< its sides are T of the nearest head; else the whole map is shown
};

struct FrameOutputs {
  /// RGBA16F, linear, with bloom; alpha = share of the pixel that is skin
  frame::TextureId picture;
  frame::TextureId before_bloom;       ///< RGBA16F, as picture
  frame::TextureId display;            ///< RGBA8, after the tone map
  frame::BufferId counters;            ///< uint[]; Technique::report says what they mean
  std::map<std::string, Shown> shows;  ///< by name: "irradiance", "shadow:0", ...
  /// That grow with the heads and skin meshes of a batch; techniques/memory.h sums them.
  std::vector<frame::TextureId> light_maps, shadow_maps;
};

/// What a frame has computed, for its statistics. docs/measuring.md says what each figure means.
struct FrameReport {
  std::uint64_t skin_pixels = 0;
  std::vector<std::string> optimise;  ///< of cull, depth, clip
  std::string mask, maps;             ///< empty: there are none
  bool translucency = false;
  std::uint64_t irradiance_texels = 0, convolved_texels = 0, launched = 0;
  std::uint64_t unshaded_reads = 0, transmission_misses = 0;
};

/// Gutters that a frame reads: of a skin mesh, for light maps of side x side texels.
struct GutterSize {
  std::uint32_t mesh = 0, side = 0;
  int width_texels = 0;
};

struct Technique {
  std::string_view name;
  std::string_view summary;    ///< one line
  bool uses_profile = true;    ///< light spreads as the material's profile says
  bool has_light_maps = true;  ///< Optimise, mask, progressive and translucency mean something
  FrameOutputs (*build)(passes::FramePlan& plan, const FrameSettings& settings);

  /// `counters` as read back from FrameOutputs::counters. `sides`: T of each head that is drawn, texels.
  FrameReport (*report)(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                        std::span<const std::uint32_t> sides);
  std::vector<GutterSize> (*gutters)(const FrameSettings& settings, std::span<const std::uint32_t> sides);
};

/// In the order in which users see them; the first is the default.
std::span<const Technique* const> techniques();
/// InputError lists the names when there is none such.
const Technique& find_technique(std::string_view name);

}  // namespace dermis::techniques
