// SPDX-License-Identifier: MIT
/// The contract of a technique: which passes, in which order, make a picture. A technique is a constant with
/// its names and three functions; the list in all.cpp is the only register. The smallest complete one is
/// lambert/.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frame/graph.h"
#include "render/passes/frame_data.h"
#include "render/techniques/frame_settings.h"

namespace dermis::techniques {

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
  /// Light of that head: of this term, or of all. There only if the head reads it, see mapped_terms.h.
  enum class Needs : std::uint8_t { nothing, irradiance, term };
  Needs needs = Needs::nothing;
  std::uint32_t term = 0;
};

/// Outputs of a plan. The executor of the plan owns the textures and the buffer; these are handles.
struct FrameOutputs {
  /// RGBA16F, linear, with bloom; alpha = share of the pixel that is skin
  frame::TextureId picture;
  frame::TextureId before_bloom;  ///< RGBA16F, as picture
  frame::TextureId display;       ///< RGBA8, after the tone map
  frame::BufferId linear;         ///< `picture` as 32-bit floats; not valid unless asked for
  frame::BufferId matte;          ///< of render/passes/pixels/open_share; likewise
  frame::BufferId labels;         ///< of render/passes/pixels/labels; likewise
  frame::BufferId counters;       ///< uint[]; Technique::report says what they mean
  /// With FrameSettings::host, in place of the pictures. Targets of the host; the light that it reads,
  /// RGBA16F, see passes::ScatterSum.
  frame::TextureId host_colour, host_depth, scattered;
  std::map<std::string, Shown> shows;  ///< by name: "irradiance", "shadow:0", ...
  /// That grow with the heads and skin meshes of a batch; render/techniques/memory.h sums them.
  std::vector<frame::TextureId> light_maps, shadow_maps;
  /// The places of the light of each head, by skin mesh, for passes::Head; none without light maps.
  std::vector<std::vector<passes::MapPlace>> map_places;
};

/// Counts of a frame, for its statistics. docs/methodology.md says what each figure means.
struct FrameReport {
  std::uint64_t skin_pixels = 0;
  std::vector<std::string> optimise;  ///< of cull, depth, clip
  std::string mask;                   ///< empty: there is none
  bool translucency = false, shape_aware = false;
  std::uint64_t irradiance_texels = 0, convolved_texels = 0, launched = 0;
  std::uint64_t unshaded_reads = 0, transmission_misses = 0;
  std::uint64_t light_reads = 0;  ///< taps over light maps at the mean density of unwraps; 0: not counted
};

/// Gutters that a frame reads: those of one skin mesh, for light maps of side x side texels.
struct GutterSize {
  std::uint32_t mesh = 0, side = 0;
  int width_texels = 0;
};

/// Number of taps that a kernel may have.
struct TapRange {
  std::uint32_t least = 0, most = 0, usual = 0;
  bool odd = false;  ///< their number is odd
  /// Number of taps of ScreenKernel::published, whatever is asked for; 0: as many as are asked for.
  std::uint32_t published = 0;
};

struct Technique {
  std::string_view name;       ///< as RenderSettings::technique names it
  std::string_view summary;    ///< one line, for help texts
  bool uses_profile = true;    ///< light spreads as the material's profile says
  bool has_light_maps = true;  ///< Optimise, mask and translucency mean something
  /// As the papers have it: skin is lit and shaded where it is drawn, one skin mesh after the other, with
  /// masks that are drawn. Takes no poses and no hosts, and knows no laws of shape.
  bool as_published = false;
  /// Skin is shaded as entries, whatever the settings say, as by techniques that blur light in the picture.
  bool screen_space = false;
  bool curvature = false;  ///< it needs GpuMesh::welded
  bool ue_kernel = false;  ///< it has ScreenKernel::ue
  TapRange taps{};         ///< of its kernels; it has none if `most` is 0
  /// Returns how many taps its blur in the picture takes per pixel of skin; null: it has none.
  std::uint32_t (*taps_per_pixel)(const FrameSettings& settings) = nullptr;

  /// Adds the passes of a frame to the empty `plan`, in the order in which they run. Needs no device.
  FrameOutputs (*build)(passes::FramePlan& plan, const FrameSettings& settings);

  /// Makes the light maps and shadow maps of such a frame in `plan`, without the passes that fill them, and
  /// returns these alone. Quick however many skin meshes there are: for render/techniques/memory.h.
  FrameOutputs (*maps)(passes::FramePlan& plan, const FrameSettings& settings);

  /// Returns what a frame of these settings has computed. `counters`: as read back from
  /// FrameOutputs::counters; `heads` as FrameSettings::heads has them: of those that are not visible
  /// nothing counts.
  FrameReport (*report)(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                        std::span<const passes::Head> heads);

  /// Returns the gutters that must be there before a frame of these heads is drawn: passes::GpuAsset makes
  /// them. None for heads that are not visible; reads no more of them than model and detail. May name one
  /// twice.
  std::vector<GutterSize> (*gutters)(const FrameSettings& settings, std::span<const passes::Head> heads);
};

/// Returns all techniques, in the order in which users see them; the first is the default.
std::span<const Technique* const> techniques();
/// Adds one that does not ship with dermis, behind the others; before any renderer is made, from one thread.
/// Must outlive them. Throws InputError: the list has this name.
void add(const Technique& technique);
/// Returns the technique of this name. Throws InputError if there is none (lists the names).
const Technique& find_technique(std::string_view name);

}  // namespace dermis::techniques
