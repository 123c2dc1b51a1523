// SPDX-License-Identifier: MIT
// Data that changes per frame, for passes while they record.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "frame/plan.h"
#include "gpu/cmd.h"
#include "gpu/resources.h"
#include "render/passes/asset/gpu_asset.h"
#include "render/passes/light_map/kept_maps.h"
#include "render/passes/light_map/mapped_terms.h"
#include "render/passes/pixels/pixel_area.h"
#include "render/shared/scene_io.h"

namespace dermis::passes {

/// Where the light of one skin mesh of a head lies in the textures that heads share: see
/// render/passes/light_map/light_pool.h.
struct MapPlace {
  std::uint32_t index = 0;  ///< of the square
  glm::uvec2 cell{0};       ///< column and row of the pool
  std::uint32_t side = 0;   ///< of its cell, texels
  std::uint32_t batch = 0;  ///< turn of the pool in which the light is there
};

/// RGBA16F over the unwrap of a skin mesh, environment::SkyLight: a layer of what is direct, one of what has
/// bounced. One texture in place of two: devices may have no more than 32 bindings.
struct SkyMaps {
  gpu::Texture light;
};

/// A shadow map of a host, in the place of one layer.
struct HostShadowMap {
  const gpu::Texture* depth = nullptr;  ///< ready to be sampled; null: none
  bool reversed = false;                ///< near is 1
};

/// Buffers of an instance that takes poses, in place of those of its asset; they last from frame to frame.
struct PosedShape {
  /// VertexIo[], one per skin mesh, then one per page of surfaces
  std::vector<gpu::Buffer> vertices;
  /// vec3[], likewise: positions before the last frame that moved them, for motion vectors
  std::vector<gpu::Buffer> before_m;
  std::vector<gpu::Buffer> skin_vertices;  ///< SkinVertexIo[], one per skin mesh: with the moved metric
  /// The sky that its skin sees, one per skin mesh; empty until there is an environment. RGBA16F.
  struct Sky {
    gpu::Texture light;        ///< as SkyMaps
    gpu::Texture bent_normal;  ///< as GpuMesh::bent_normal
    gpu::Buffer turns;         ///< vec4[], per vertex: the quaternion from the asset to the pose
  };
  std::vector<Sky> sky;
};

/// An instance that this frame moves.
struct RigMove {
  const PosedShape* shape = nullptr;
  const GpuAsset* asset = nullptr;       ///< with its rig
  gpu::BufferBinding matrices, weights;  ///< mat4x3[], float[]: scene::PosedRig
};

/// An instance whose light of the sky this frame finds anew.
struct SkyTurn {
  const PosedShape* shape = nullptr;
  const GpuAsset* asset = nullptr;  ///< with its rig
  gpu::BufferBinding sky;           ///< SkyHarmonicsIo
};

/// One head in the frame: an asset, placed. Each has its own shadow maps.
struct Instance {
  std::uint32_t number = 0;         ///< among the heads of the scene, however the plan sorts them
  const GpuAsset* asset = nullptr;  ///< shared by all instances of the asset
  const GpuLook* look = nullptr;    ///< its materials
  std::span<const SkyMaps> sky;     ///< one per skin mesh of the asset; only with an environment
  gpu::BufferBinding io;            ///< HeadIo
  glm::mat4x3 world_from_asset{1};
  glm::vec3 middle_m{0};                     ///< of its skin, in the world
  std::uint32_t first_mesh = 0;              ///< of its skin, among the skin meshes of the plan
  std::uint32_t first_shadow_layer = 0;      ///< where this head's layers begin
  std::vector<glm::mat4> shadow_from_world;  ///< of this head's layers, for drawing them
  std::uint32_t shadow_side = 0;             ///< of its maps, in the corner of their layers, texels
  /// Of what these layers show: the same number, the same depths and entering light. 0: may change unseen.
  std::uint64_t shadow_version = 0;
  /// Images of a host for these layers, null where dermis draws them; empty: it draws all.
  std::vector<HostShadowMap> host_shadows;
  std::span<const gpu::Buffer> vertices;  ///< moved, one per skin mesh; empty: those of `asset`
  const PosedShape* posed = nullptr;      ///< of an instance that takes poses
  bool moves = false;                     ///< it has moved since the last frame, or this is its first
  std::vector<gpu::BufferBinding>
      placements;             ///< posed, PlacementIo[], one per page; empty: those of `asset`
  gpu::BufferBinding before;  ///< LabelsBeforeIo, for labels; else none
  std::vector<gpu::BufferBinding> placements_before;  ///< likewise, as `placements`; empty: those are still
  /// T: the used side of the square of its light maps, texels
  std::uint32_t map_side = 0;
  std::vector<MapPlace> map_places;  ///< one per skin mesh of the asset; empty where nothing has light maps
  std::vector<MappedTerms> mapped_terms;  ///< likewise; empty: all
  bool visible = true;                    ///< false: wholly outside the picture, not lit or drawn
  bool drawn = true;                      ///< false: lit, but a host draws it
  bool is_drawn() const { return visible && drawn; }
};

struct UsedSquare;

/// Draws irradiance into squares of a map, RGBA16F, ready to be rendered to and cleared to 0.
using DrawIrradiance =
    std::function<void(gpu::Cmd& cmd, const gpu::Texture& map, std::span<const UsedSquare> squares)>;

/// Buffers lie in the memory of the frame, which must outlive this.
struct FrameData {
  io::CameraIo camera{};                      ///< that of frame_io
  gpu::BufferBinding frame_io;                ///< FrameIo
  gpu::BufferBinding lamps;                   ///< LightIo[] and mat4[] of all heads: LampsIo
  const gpu::Texture* environment = nullptr;  ///< RGBA16F, prefiltered; none: uniform light
  /// RGBA16F, what stands behind the heads, with its lamps; none: uniform light, or it is not shown
  const gpu::Texture* environment_picture = nullptr;
  std::vector<Instance> instances;   ///< at least one
  std::vector<RigMove> moves;        ///< those that move in this frame, each once
  std::vector<SkyTurn> sky_turns;    ///< those, and any in a pose under another sky than before
  std::optional<VkRect2D> area;      ///< part of the targets that is the picture; none: all
  PixelArea heads;                   ///< of the targets: beside it is no head
  DrawIrradiance draw_irradiance;    ///< of a host
  KeptMaps* kept_shadows = nullptr;  ///< of the memory of the plan; none: all shadow maps are drawn
  KeptMaps* kept_texels = nullptr;   ///< likewise of TexelMap
};

using FramePlan = frame::FramePlan<FrameData>;

}  // namespace dermis::passes
