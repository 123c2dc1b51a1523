// SPDX-License-Identifier: MIT
/// A head on its way through a frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "gpu/cmd.h"
#include "gpu/resources.h"
#include "head/scene/similarity.h"
#include "render/passes/asset/gpu_asset.h"
#include "render/passes/light_map/mapped_terms.h"
#include "render/passes/pixels/pixel_area.h"
#include "render/shared/scene_io.h"

namespace dermis::passes {

/// The place of the light of one skin mesh of a head in the textures that heads share: see
/// render/passes/light_map/light_pool.h.
struct MapPlace {
  std::uint32_t index = 0;        ///< of the square
  glm::uvec2 origin{0};           ///< texels
  std::uint32_t square_side = 0;  ///< the most that its head may use, texels
  std::uint32_t batch = 0;        ///< turn of the pool in which the light is there
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

/// An instance of the scene in a frame, or one of a row of them. Each has its own shadow maps.
struct Head {
  // Decided by setup::set_up() and set_view(), for a camera.
  std::uint32_t number = 0;  ///< among the heads of the scene, however the plan sorts them
  std::size_t instance = 0;  ///< of the scene
  std::uint32_t model = 0;   ///< of the plan
  scene::Similarity world_from_asset;
  glm::vec3 middle_m{0};                     ///< of its skin, in the world
  MapDetail detail;                          ///< of its light maps: T, and pixels per mm
  std::vector<io::LightIo> lights;           ///< with their shadow maps
  std::uint32_t first_shadow_layer = 0;      ///< where this head's layers begin
  std::vector<glm::mat4> shadow_from_world;  ///< of this head's layers, for drawing them
  std::uint32_t shadow_side = 0;             ///< of its own maps, in the corner of their layers, texels
  /// Images of a host for these layers, null where dermis draws them; empty: it draws all.
  std::vector<HostShadowMap> host_shadows;
  PixelArea area;       ///< of the picture: pixels outside do not show it
  bool visible = true;  ///< false: hidden, or left out as wholly outside the picture; neither lit nor drawn
  bool drawn = true;    ///< false: lit, but a host draws it
  bool is_drawn() const { return visible && drawn; }

  // Resources of its instance, which must outlive the frame: those of api::SceneOnDevice, and moved ones of
  // api::HostMoves and api::PosedInstances.
  const GpuAsset* asset = nullptr;        ///< shared by all instances of the asset
  const GpuLook* look = nullptr;          ///< its materials
  std::span<const SkyMaps> sky;           ///< one per skin mesh of the asset; only with an environment
  std::span<const gpu::Buffer> vertices;  ///< moved by a host, one per skin mesh; empty: those of `asset`
  const PosedShape* posed = nullptr;      ///< of an instance that takes poses

  // Written for a frame, by setup::frame_data() and what fills poses, versions of shadows and labels.
  gpu::BufferBinding io;             ///< HeadIo
  std::uint32_t first_mesh = 0;      ///< of its skin, among the skin meshes of the plan
  std::vector<MapPlace> map_places;  ///< one per skin mesh of the asset; empty where nothing has light maps
  std::vector<MappedTerms> mapped_terms;  ///< likewise; empty: all
  /// PlacementIo[] of its pose, one per page; empty: those of `asset`.
  std::vector<gpu::BufferBinding> placements;
  bool moves = false;  ///< it has moved since the last frame, or this is its first
  /// Names the content of its shadow layers: the same number, the same depths and entering light. 0: that may
  /// change unseen.
  std::uint64_t shadow_version = 0;
  gpu::BufferBinding before;                          ///< LabelsBeforeIo, for labels; else none
  std::vector<gpu::BufferBinding> placements_before;  ///< likewise, as `placements`; empty: those are still
};

/// Returns how an asset stands in the world, as shaders read it.
inline io::SimilarityIo similarity_io(const scene::Similarity& world_from_asset) {
  return {.x_axis = world_from_asset.rotation[0],
          .y_axis = world_from_asset.rotation[1],
          .z_axis = world_from_asset.rotation[2],
          .origin_m = world_from_asset.origin_m,
          .scale = world_from_asset.scale};
}

}  // namespace dermis::passes
