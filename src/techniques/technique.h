// SPDX-License-Identifier: MIT
/// How passes make a picture. A technique is a function that adds passes to a plan; the list in all.cpp is
/// the only register.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frame/plan.h"
#include "gaussians/sum.h"
#include "image/tone_map.h"
#include "passes/downsample/downsample.h"
#include "passes/light_pool.h"

namespace dermis::techniques {

/// One skin mesh as the plan needs to know it.
struct SkinPart {
  gaussians::SumOfGaussians profile;
  double max_texels_per_mm = 1;   ///< where its unwrap is densest, at the map size of the frame
  double mean_texels_per_mm = 1;  ///< of its unwrap, at the same size
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

/// The structure of a frame: a change makes a new plan. What changes per frame is frame::FrameData.
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
  image::ToneMap tone_map = image::ToneMap::natural;
  bool operator==(const FrameSettings&) const = default;
};

/// Side of the maps of what enters the skin (passes::Shadow), texels. Their light goes to light maps, so they
/// need not be finer than those. Within a factor of 1.5 a pass of their own would save neither time nor
/// memory: they are drawn with the shadow maps then, and as large.
inline std::uint32_t entering_size(const FrameSettings& s) {
  return 3 * std::uint64_t{s.map_size} <= 2 * std::uint64_t{s.shadow_size} ? s.map_size : s.shadow_size;
}
/// Of one layer of the shadow maps, with what belongs to it.
inline std::uint64_t shadow_bytes(const FrameSettings& s) {
  const std::uint64_t depth = 4 * std::uint64_t{s.shadow_size} * s.shadow_size;
  const std::uint64_t side = entering_size(s), entering = 4 * side * side;
  if (!s.translucency || s.all_enters) return depth;
  return depth + (side < s.shadow_size ? 2 * entering : entering);  // apart, it has depth of its own
}

/// Slots of FrameOutputs::counters: three of the frame, then for each skin mesh three for each size of its
/// maps.
enum Counter : std::uint32_t {
  counter_skin_pixels,
  counter_unshaded_reads,
  counter_transmission_misses,
  counter_meshes
};
enum MeshCounter : std::uint32_t {
  counter_lit_texels,
  counter_masked_texels,
  counter_tiles,
  counter_level_stride
};
inline constexpr std::uint32_t counter_mesh_stride = counter_level_stride * (passes::max_halvings + 1);
inline std::size_t counter_count(std::size_t skin_meshes) {
  return counter_meshes + counter_mesh_stride * skin_meshes;
}
inline std::uint32_t mesh_counter(std::uint32_t mesh, std::uint32_t halvings, MeshCounter which) {
  return counter_meshes + counter_mesh_stride * mesh + counter_level_stride * halvings + which;
}

struct FrameOutputs {
  /// RGBA16F, linear, with bloom; alpha = share of the pixel that is skin
  frame::TextureId picture;
  frame::TextureId before_bloom;                  ///< RGBA16F, as picture
  frame::TextureId display;                       ///< RGBA8, after the tone map
  frame::BufferId counters;                       ///< uint[counter_count()]
  std::map<std::string, frame::TextureId> shows;  ///< what `--show` can show: "irradiance", "blur:0", ...
  /// of the square of light maps that is shown: the nearest head's, its first skin mesh
  glm::uvec2 shown_origin{0};
  /// A skin mesh, by halvings of the map: what runs over its square there.
  struct LevelWork {
    std::uint32_t terms = 0;         ///< Gaussians that end there
    std::uint32_t convolutions = 0;  ///< passes, both axes counted
    bool halved = false;             ///< the level is made by Downsample
  };
  std::vector<std::array<LevelWork, passes::max_halvings + 1>> work;
};

struct Technique {
  std::string_view name;
  std::string_view summary;  ///< one line
  bool scatters = true;      ///< uses the profile
  FrameOutputs (*build)(frame::FramePlan& plan, const FrameSettings& settings);
};

std::span<const Technique> techniques();
/// InputError lists the names when there is none such.
const Technique& find_technique(std::string_view name);

}  // namespace dermis::techniques
