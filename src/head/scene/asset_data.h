// SPDX-License-Identifier: MIT
// Content of an asset: heads and their other parts, maps, lights, cameras. All
// in the world at rest: nodes as they stand, skins and morph targets applied, mirrored nodes wound
// counter-clockwise. Only meshes that several nodes share stay in their own coordinates, with a list of
// placements. Metres, right-handed, +Y up. No Vulkan here.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dermis/asset_arrays.h"
#include "dermis/light.h"
#include "head/scene/skin_mesh.h"
#include "image/image.h"
#include "tissue/gaussians/sum.h"

namespace dermis::scene {

/// A map of a material: image, texture coordinates and their transform, uv' = transform * (u, v, 1).
struct MapRef {
  int image = -1;  ///< index into AssetData::images, -1 = none
  int uv_set = 0;  ///< 0 or 1
  /// columns: image of u, image of v, offset (KHR_texture_transform)
  glm::mat3x2 transform{1, 0, 0, 1, 0, 0};
  AssetWrap wrap_u = AssetWrap::repeat;
  AssetWrap wrap_v = AssetWrap::repeat;
  bool nearest = false;  ///< magnification filter
  int channel = 0;       ///< for single-channel maps: index in RGBA
  float scale = 1;       ///< normal scale, occlusion strength, or factor on the map's value
  bool present() const { return image >= 0; }
};

struct SpecularLobe {
  float roughness_factor = 1;  ///< multiplies m
  float weight = 1;
};

/// `extras.dermis` of a skin material; defaults: rho_s 0.18, two lobes.
struct SkinMaterial {
  std::optional<ScatterProfile> profile;  ///< none: the default of the command
  /// 0..1, part of the albedo applied before scattering; none: 0.5
  std::optional<float> mix;
  float mix_or_default() const { return mix.value_or(0.5f); }
  MapRef specular;  ///< multiplies rho_s; scale as factor
  /// glTF roughness (m = roughness^2); scale as factor. Absent: Material::roughness
  MapRef roughness;
  MapRef displacement;               ///< height map, turned into fine normals
  float displacement_mm = 0;         ///< black to white
  float displacement_middle = 0.5f;  ///< value of zero height
  MapRef detail;  ///< tiled normals, finer than the normal map; in its tangent space; scale = normal scale
  std::vector<SpecularLobe> lobes{{0.75f, 0.85f}, {1.3f, 0.15f}};  ///< 1 or 2, weights sum to 1
};

struct Material {
  std::string name;
  bool skin = false;         ///< never with AssetAlpha::blend: the loader makes such skin a surface
  glm::vec4 base_colour{1};  ///< linear
  MapRef base_colour_map;    ///< sRGB
  float metallic = 1, roughness = 1;
  MapRef metallic_roughness_map;  ///< G roughness, B metallic
  MapRef normal_map;              ///< tangent space, +Y up; scale = normal scale
  MapRef occlusion_map;           ///< R; scale = strength
  glm::vec3 emissive{0};          ///< emissive strength included
  MapRef emissive_map;            ///< sRGB
  float ior = 1.5f;               ///< skin default 1.4
  float specular = 1;             ///< KHR_materials_specular factor
  MapRef specular_map;            ///< A
  glm::vec3 specular_colour{1};
  MapRef specular_colour_map;  ///< sRGB
  AssetAlpha alpha_mode = AssetAlpha::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;
  float transmission =
      0;  ///< 0..1, part of what is not reflected that passes, in place of albedo; with blend
  MapRef transmission_map;     ///< red; its mean is in `transmission` once it is decoded
  SkinMaterial skin_settings;  ///< only if skin
};

/// One placement of a mesh that several nodes share.
struct Placement {
  glm::dmat4x3 world_from_mesh{1};  ///< columns: images of x, y, z and the origin, metres
  int node = -1;
  bool mirrored = false;  ///< inside out: triangles wind the other way round
};

/// Triangles of one material of one node, or of several nodes that share them. indices.size() is a multiple
/// of 3, all < vertices.size().
struct Primitive {
  std::string name;  ///< node or mesh name, for messages; of the first node if it is shared
  int material = 0;  ///< index into AssetData::materials
  int node = -1;     ///< node it came from; skin of one node shares one unwrap, see skin_mesh_key()
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  bool has_uv = false;  ///< the file has TEXCOORD_0
  /// Skin whose charts lie where those of another material of its node lie: see part_overlapping_skin().
  bool own_light_map = false;
  /// Empty: one copy, whose vertices are in the world. Else vertices are in the mesh's own coordinates.
  /// Always empty for skin, whose metric is in mm. head/scene/placement.h reads both.
  std::vector<Placement> placements;
  /// number of the mesh that it came from, as include/dermis/asset.h counts them
  int source_mesh = 0;
  /// Per vertex, its number in the arrays or accessors of that mesh. Empty: the same as here. See
  /// source_vertex().
  std::vector<std::uint32_t> source_vertices;
};

/// Returns the number that vertex `vertex` has in what the primitive came from.
inline std::uint32_t source_vertex(const Primitive& primitive, std::uint32_t vertex) {
  return primitive.source_vertices.empty() ? vertex : primitive.source_vertices[vertex];
}

/// A decoded map. Shared, so that copies of scenes are cheap.
struct MapImage {
  std::string name;
  std::shared_ptr<const image::Image8> pixels;  ///< never null
};

/// KHR_lights_punctual semantics in relative radiometric units: irradiance pi on white Lambert shows as 1.
/// `colour` includes intensity: irradiance facing the light = colour (directional), colour / d^2 with d in
/// metres (spot, point).
struct Light {
  std::string name;
  LightType type = LightType::directional;
  glm::vec3 colour{1};
  glm::vec3 position_m{0};  ///< spot, point
  /// unit, direction in which light travels (directional, spot)
  glm::vec3 direction{0, 0, -1};
  float range_m = 0;                                     ///< 0 = unlimited
  float inner_cone_rad = 0, outer_cone_rad = 0.785398f;  ///< half angles (spot)
  /// Radius of a disc that faces the lit point, for penumbrae; 0 = a point. m; directional: tangent of the
  /// angular radius.
  float radius = 0;
};

/// Perspective unless orthographic. Looks along -Z of its frame.
struct Camera {
  std::string name;
  glm::mat4 world_from_camera{1};  ///< rigid
  float fov_y_rad = 0.349066f;
  float znear_m = 0.01f;
  std::optional<float> zfar_m;  ///< none = infinite
  bool orthographic = false;
  float ymag_m = 1;             ///< half height if orthographic
  std::optional<float> aspect;  ///< width / height of what it shows; none: that of the picture
  /// Where the axis meets the picture, 0 in the middle, 1 at its right and upper border.
  glm::vec2 axis_at{0};
};

struct BoundingSphere {
  glm::vec3 centre_m{0};
  float radius_m = 0;
};

struct Bounds {
  glm::vec3 low_m{0}, high_m{0};  ///< of the box
  BoundingSphere sphere;          ///< bounding_sphere() of framing.h
};

struct Rig;  // head/scene/rig/rig.h

struct AssetData {
  std::string name;  ///< file name, or "built-in"
  std::vector<Primitive> primitives;
  std::vector<Material> materials;
  std::vector<MapImage> images;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  std::vector<std::string> clips;  ///< names of its animations
  /// The rig that poses it again; null: nothing can move. Shared, as pixels are.
  std::shared_ptr<const Rig> rig;
  std::string why_no_rig;  ///< empty: there is one, or nothing can move
  /// world metres to mm; unit_scale multiplies positions at load, so this stays 1000
  double mm_per_unit = 1000;

  // measured() of surface/measured.h fills these. Of a copy whose vertices were moved they are old.
  std::vector<SkinMesh> skin;               ///< skin_meshes()
  Bounds bounds;                            ///< skin_bounds()
  BoundingSphere casters;                   ///< of everything: hair cards and collars cast shadows too
  std::vector<glm::vec3> caster_corners_m;  ///< enclosing_corners() of the same
};

}  // namespace dermis::scene
