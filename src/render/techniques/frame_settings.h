// SPDX-License-Identifier: MIT
/// The structure of a frame: what a technique plans it from.
#pragma once

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dermis/settings.h"
#include "render/passes/frame_data.h"
#include "render/passes/light_map/light_pool.h"
#include "render/passes/pixels/behind.h"
#include "render/passes/pixels/shade/skin_shading.h"
#include "render/passes/targets.h"
#include "tissue/gaussians/sum.h"

namespace dermis::techniques {

/// One skin mesh as the plan needs to know it, in mm of its asset: an instance of scale s has a profile that
/// is s times narrower there. Texels per mm of a map are uv per mm (texture coordinates, 0..1) times its
/// side.
struct PlannedMesh {
  ScatterProfile profile;
  /// Light that leaves where it entered: the weight of a Gaussian of variance 0, which `profile` lacks. If
  /// all light does, `profile` has one Gaussian without weight.
  gaussians::Rgb unscattered{};

  /// T_max of its heads: less than that of the plan where others need more.
  std::uint32_t most_side = 2048;
  /// The terms of `profile` that light maps may hold, all from this one on; the others are lit at the pixel.
  std::uint32_t first_mapped = 0;
  /// Some head is so far away that pixels read the light before any blur in place of the terms before
  /// mapped(): entered_share() of mapped_terms.h.
  bool reads_entered = false;

  std::span<const Gaussian> mapped() const { return std::span(profile.terms).subspan(first_mapped); }
  std::uint32_t mapped_count() const {
    return static_cast<std::uint32_t>(profile.terms.size()) - first_mapped;
  }
  /// Returns the groups of light through the body that maps hold, by their first term of mapped().
  std::vector<std::size_t> through_groups() const {
    return passes::mapped_groups(profile.terms.size(), first_mapped);
  }

  double mm_per_unit = 1000;  ///< mm of the asset per metre of the world
  /// Number of the mesh whose unwrap this is: instances of an asset that differ in their profile share it.
  std::uint32_t unwrap = 0;
  std::uint32_t in_model = 0;  ///< number among the meshes of its model
  std::uint32_t triangles = 0, vertices = 0;
  std::uint32_t draws = 1;  ///< runs of triangles of one material: passes::GpuMesh::draws
  std::uint32_t parts = 1;  ///< of these, for ids: passes::GpuDraw::parts

  double max_uv_per_mm = 1;    ///< in the densest direction; a twentieth of the skin has more
  double mean_uv_per_mm = 1;   ///< geometric mean of both directions
  double least_uv_per_mm = 1;  ///< a twentieth of the skin has fewer
  double wide_mm = 0;          ///< sigma of the narrowest terms that light maps hold near by: sides_by_need.h
  bool off_map = false;        ///< some of its triangles have no chart of the unwrap
  bool cut_out = false;        ///< some of its materials have an alpha test
  std::bitset<passes::SkinKind::count> kinds = 1;  ///< of its materials: passes::SkinLook

  /// Returns the texels per mm of maps of this side that a twentieth of the skin exceeds.
  double max_texels_per_mm(std::uint32_t side) const { return std::max(max_uv_per_mm * side, 1e-6); }
  bool posed = false;  ///< it takes poses: its metric changes from frame to frame
  /// Returns how light comes through it, as skin mesh `mesh` of the plan.
  passes::ThroughMesh through(std::uint32_t mesh) const {
    return {.mesh = mesh, .profile = profile, .mm_per_unit = mm_per_unit, .first_mapped = first_mapped};
  }
  bool operator==(const PlannedMesh&) const = default;
};

/// Instances of an asset that have the same profile and scale.
struct Model {
  std::uint32_t first_mesh = 0, meshes = 0;  ///< of FrameSettings::skin
  bool has_surfaces = false, has_blended = false;
  bool operator==(const Model&) const = default;
};

/// Skips what is not seen. Based on: [JG08] sec. 3 to 5.
struct Optimise {
  bool cull = false;  ///< leaves out triangles that face away from the camera
  /// uses only as much of the maps as the head's distance needs: changes MapDetail::side, and the plan
  /// where a head comes close (sides_by_need.h)
  bool depth = false;
  bool clip = false;  ///< leaves out what lies outside the picture and a margin
  bool any() const { return cull || depth || clip; }
  bool operator==(const Optimise&) const = default;
};

/// A host's share in a frame: see dermis/vulkan.h.
struct HostPart {
  std::optional<passes::PictureFormat> picture;  ///< the heads are drawn into its targets; none: they are not
  std::uint32_t width = 0, height = 0;           ///< of its largest targets, pixels: room for ids and entries
  bool scattered = false;                        ///< it reads the blurred light
  bool irradiance = false;                       ///< it draws the irradiance
  bool shadows = false;                          ///< it has shadow maps for some lights
  bool operator==(const HostPart&) const = default;
};

/// The structure of a frame: a change makes a new plan. Data that change per frame are passes::FrameData.
struct FrameSettings {
  std::uint32_t width = 1280, height = 720;  ///< pixels
  std::uint32_t samples = 4;                 ///< per pixel, 1 or 4
  std::uint32_t light_samples = 2;           ///< of a pixel that one surface covers, 1 or 2
  std::uint32_t most_side = 2048;            ///< T_max, texels per side
  std::uint32_t stretch_side = 1024;         ///< of the maps of the metric, texels
  std::uint32_t shadow_size = 1024;          ///< texels per side
  std::uint32_t shadow_layers = 1;           ///< of one head, at least 1

  /// The model of each head, in the order in which they are drawn.
  std::vector<std::uint32_t> heads{0};
  std::uint32_t square_side = 2048;  ///< of the pool of light maps: no head uses more texels
  /// Heads that are lit and blurred together. The pool has a square for each skin mesh of each of them.
  std::uint32_t heads_per_batch = 1;
  /// Skin meshes of a head that are lit and blurred together, 0 = all. If not all, heads_per_batch is 1.
  std::uint32_t meshes_per_batch = 0;
  /// Each head has a set of shadow maps of its own, which lasts from frame to frame; else there are as many
  /// sets as heads are lit together.
  bool keep_shadows = false;

  Optimise optimise;
  /// Light comes through the body: lit from behind, thin skin glows.
  bool translucency = false;
  /// All that casts shadows is skin whose whole albedo acts after scattering (mix 0), so that all light
  /// enters its front. A map then stores which side the light meets, and not which part of it enters.
  bool all_enters = false;
  BlurMask mask = BlurMask::depth;  ///< of technique `published`
  bool all_mapped = false;          ///< every term is read from its map, whatever T
  bool visibility = false;          ///< also makes the map that `output.show` "visibility" shows
  bool irradiance = false;          ///< likewise "irradiance"; else its map may end as another
  bool picture = true;              ///< skin is lit and shaded; else the frame has labels alone
  bool display = true;              ///< FrameOutputs::display is drawn
  bool linear = false;              ///< FrameOutputs::linear is written
  bool matte = false;               ///< FrameOutputs::matte is written
  std::uint32_t labels = 0;         ///< LABEL_... bits of render/passes/pixels/labels: FrameOutputs::labels

  std::vector<PlannedMesh> skin;  ///< the skin meshes of all models
  std::vector<Model> models{1};
  ScreenKernel kernel = ScreenKernel::profile;  ///< of techniques in screen space
  std::uint32_t taps = 0;                       ///< of their kernels; 0: as many as usual

  bool poses = false;         ///< some instance takes poses: passes::MoveRig
  bool environment = false;   ///< light from a picture of the surroundings, else uniform
  bool soft_shadows = false;  ///< some light has a radius
  float bloom = 0;            ///< 0..1
  ToneMap tone_map = ToneMap::natural;
  passes::Behind behind;         ///< the heads; black for a host, which composes by itself
  std::optional<HostPart> host;  ///< none: the frame ends as a picture of ours
  bool operator==(const FrameSettings&) const = default;

  /// Sets T_max of the plan and of its meshes, and all sides that follow it.
  void set_most_side(std::uint32_t side) {
    most_side = stretch_side = square_side = side;
    for (PlannedMesh& part : skin) part.most_side = side;
  }
  std::uint32_t head_count() const { return static_cast<std::uint32_t>(heads.size()); }
  std::uint32_t shadow_sets() const { return keep_shadows ? head_count() : heads_per_batch; }
  const Model& model_of(std::uint32_t head) const { return models[heads[head]]; }
  std::uint32_t most_meshes() const;                 ///< of a model
  std::uint32_t parts_of(const Model& model) const;  ///< PlannedMesh::parts of its meshes
  std::uint64_t parts() const;                       ///< of all heads
  bool draws_picture() const { return picture && (!host || host->picture); }
  bool host_lights() const { return host && host->irradiance; }
  /// Light maps hold the terms that pixels read (mapped_terms.h), on as few texels as they take
  /// (sides_by_need.h). The rest of the light is lit at the pixel. Light that a host draws is known in the
  /// maps alone.
  bool mixes() const { return optimise.depth && !all_mapped && !host_lights(); }
  /// Returns the texels per mm of maps of T that bound the first step of the part's chain of blurs. A
  /// twentieth of its skin exceeds them. T by need suits the mean density. The densest places let taps of the
  /// first step leave texels out there, which saves a step. Its light is off by less than 1 %
  /// (docs/techniques.md).
  double chain_texels_per_mm(const PlannedMesh& part, std::uint32_t side) const {
    return part.max_texels_per_mm(side) / (mixes() ? 1.5 : 1);
  }
  double chain_texels_per_mm(const PlannedMesh& part) const {
    return chain_texels_per_mm(part, part.most_side);
  }
  bool has_skin() const { return parts() > 0; }
  passes::PictureFormat picture_format() const {
    return host && host->picture ? *host->picture : passes::PictureFormat{};
  }
};

}  // namespace dermis::techniques
