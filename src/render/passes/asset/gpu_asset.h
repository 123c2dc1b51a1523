// SPDX-License-Identifier: MIT
// An asset on the device: meshes, materials and maps, uploaded once and shared by all its instances.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/pipelines.h"
#include "gpu/resources.h"
#include "head/scene/asset_data.h"
#include "head/scene/surface/curvature.h"
#include "head/scene/surface/gutters.h"
#include "head/scene/surface/unwrap.h"
#include "render/passes/asset/gpu_rig.h"
#include "render/passes/asset/gpu_surfaces.h"
#include "render/passes/bindings.h"
#include "render/shared/entries_io.h"
#include "render/shared/scene_io.h"

namespace dermis::passes {

/// The maps of a material, shared by all its looks.
struct MaterialMaps {
  std::string name;
  io::MaterialIo constants{};                         ///< as the asset has them
  std::array<gpu::SampledBinding, MAP_COUNT> maps{};  ///< a white or flat texel if the material has none
  bool skin = false;
  bool double_sided = false;
  bool cut_out = false;   ///< skin with an alpha test
  bool emits = false;     ///< skin that emits light
  bool detailed = false;  ///< skin with a tile of detail
  gpu::SampledBinding
      alpha_max;  ///< for skin with an alpha test, see render/passes/asset/alpha_max.h; else a white texel
  AssetAlpha alpha_mode = AssetAlpha::opaque;
};

struct GpuMaterial : MaterialMaps {
  gpu::Buffer buffer;  ///< MaterialIo
  bool mixed = true;   ///< of skin: part of the albedo acts before the light scatters

  void offer(Bindings& bindings) const;  ///< "Material", "map_base_colour", ...
};

/// An image of a host in place of a map of a material.
struct HostMap {
  int material = 0;
  int map = MAP_BASE_COLOUR;  ///< or MAP_NORMAL
  VkImageView view = VK_NULL_HANDLE;
  bool operator==(const HostMap&) const = default;
};

/// The materials of an asset, as some of its instances show them.
struct GpuLook {
  std::vector<GpuMaterial> materials;
  std::vector<std::unique_ptr<gpu::Texture>> of_host;  ///< that the materials point to
  const GpuMaterial& material(int number) const { return materials[static_cast<std::size_t>(number)]; }
};

/// Changes of an instance to its materials.
struct LookSettings {
  std::optional<float> mix;  ///< 0..1, instead of the materials'
  glm::vec3 tint{1};         ///< multiplies the base colour of skin, linear
  std::vector<HostMap> maps;
  bool operator==(const LookSettings&) const = default;
};

struct GpuDraw {
  std::uint32_t first_index = 0, index_count = 0;
  int material = 0;
  bool on_map = true;  ///< for skin: the triangles have a chart of the unwrap

  /// Returns how many parts its triangles are: render/shared/entries_io.h.
  std::uint32_t parts() const { return (index_count / 3 + (1u << ID_TRIANGLE_BITS) - 1) >> ID_TRIANGLE_BITS; }
};

/// Returns the draws of a skin mesh on the device, where triangles with a chart come first: one per run of
/// triangles of one material.
std::vector<GpuDraw> draws_of(const scene::SkinMesh& mesh);

/// One skin mesh.
struct GpuMesh {
  std::string name;
  gpu::Buffer vertices;           ///< VertexIo[]
  gpu::Buffer vertex_extras;      ///< VertexExtraIo[]
  gpu::Buffer skin_vertices;      ///< SkinVertexIo[]
  gpu::Buffer indices;            ///< uint[]; triangles without a chart are last
  gpu::Buffer first_corners;      ///< uint[], first_corner_indices() of `indices`
  gpu::Buffer turned_neighbours;  ///< uint[], scene::turned_neighbours

  /// By the side of the light map, see GpuAsset::make_gutters.
  struct Gutters {
    gpu::Buffer list;        ///< GutterIo[]
    gpu::Buffer tile_links;  ///< uint[], passes::tile_links()
    std::uint32_t count = 0;
    int width_texels = 0;
  };
  std::map<std::uint32_t, Gutters> gutters;

  /// Vertices by the mesh of the asset's source that they come from, see GpuAsset::make_sources.
  struct Sources {
    gpu::Buffer list;  ///< SourceVertexIo[]
    std::uint32_t count = 0;
    std::uint32_t source_vertices = 0;  ///< that the list names: the highest number, and one
  };
  std::map<int, Sources> sources;
  const Sources* sources_of(int source_mesh) const;  ///< null: none of it is here

  /// For render/passes/pose/curvature; made by GpuAsset::make_welded.
  struct Welded {
    gpu::Buffer point_of;  ///< uint[], per vertex: one of those at its place
    int smoothing = 0;     ///< rounds of averaging neighbours
  };
  Welded welded;

  /// see unwrap_map(), Occlusion::values of environment/occlusion.h; only under an environment
  gpu::Texture bent_normal;
  /// LabelVertexIo[], regions::parts_of_skin() and the thickness at the vertices; empty until labels are
  /// drawn
  gpu::Buffer label_vertices;
  std::vector<GpuDraw> draws;
};

/// Returns an RGBA16F texture over an unwrap, from side x side x 4 values per layer; values beyond the range
/// of half floats become the largest.
gpu::Texture unwrap_map(gpu::Device& device, const std::string& name, int side,
                        std::initializer_list<const std::vector<float>*> layers);

class GpuAsset {
 public:
  /// Uploads an asset that is measured. Throws DeviceError: a map or buffer over the device's limits, no
  /// memory.
  GpuAsset(gpu::PipelineLibrary& library, const scene::AssetData& scene);

  /// Makes the materials of instances that look like this. The asset must outlive them.
  GpuLook make_look(gpu::Device& device, const LookSettings& settings) const;

  /// Makes the gutters of `mesh`, skin mesh `number`, for light maps of side x side texels, `width_texels`
  /// wide, unless it has them as wide or wider.
  void make_gutters(gpu::Device& device, std::size_t number, const scene::SkinMesh& mesh, std::uint32_t side,
                    int width_texels);

  /// Makes what finds the curvature of `mesh`, skin mesh `number`, unless it is there.
  void make_welded(gpu::Device& device, std::size_t number, const scene::SkinMesh& mesh);

  /// Gives the vertices of `mesh`, skin mesh `number`, the shape of the body, one per vertex. Copies of
  /// GpuMesh::skin_vertices that were made before lack it.
  void give_shape(gpu::Device& device, std::size_t number, const scene::SkinMesh& mesh,
                  std::span<const scene::VertexShape> shape);

  /// Makes what finds the curvature of moved skin, unless it is there: scene::curvature_stencil(). Needs a
  /// rig.
  void make_rig_curvature(gpu::Device& device, std::size_t number, const scene::SkinMesh& mesh,
                          const scene::CurvatureScales& scales);

  /// Makes the lists of the vertices of `mesh`, skin mesh `number`, that a host may move, unless they are
  /// there.
  void make_sources(gpu::Device& device, std::size_t number, const scene::SkinMesh& mesh);

  /// Makes what moves its vertices, unless it is there. The asset has a rig. Throws DeviceError: more than
  /// shaders of the device can read.
  void make_rig(gpu::Device& device, const scene::AssetData& scene);

  float mm_per_unit = 1000;                             ///< scene::AssetData::mm_per_unit
  std::vector<GpuMesh> skin;                            ///< one per SkinMesh
  std::optional<GpuRig> rig;                            ///< once a pose was asked for
  GpuSurfaces surfaces;                                 ///< everything else
  gpu::Buffer unmoved;                                  ///< PlacementIo: skin's vertices are in the world
  const gpu::Texture& white() const { return white_; }  ///< one white texel
  const gpu::Texture& white_layers() const { return white_layers_; }  ///< likewise, as an array
  gpu::Texture directional_albedo;  ///< RGBA16F, see tissue/optics/directional_albedo.h

 private:
  const gpu::Texture& texture(gpu::PipelineLibrary& library, const scene::AssetData& scene, int image,
                              bool srgb);
  const gpu::Texture& alpha_max(gpu::Device& device, const scene::AssetData& scene, int image);
  const gpu::Texture& upload_map(gpu::PipelineLibrary& library, const std::string& name,
                                 const image::Image8& pixels, int image, bool srgb);
  struct Loaded {
    int image;
    bool srgb;
    std::unique_ptr<gpu::Texture> texture;
  };
  std::vector<Loaded> textures_;
  std::map<int, gpu::Texture> alpha_max_;  // by image
  std::vector<MaterialMaps> materials_;
  gpu::Texture white_, white_layers_, flat_normal_;
};

}  // namespace dermis::passes
