// SPDX-License-Identifier: MIT
/// A head and what belongs to it, from the memory of a host: the content of a glTF file as arrays. Members
/// that are not given have glTF's defaults. The asset is that of a file with the same content, also in its
/// missing normals and tangents, blended skin, texture budget and warnings.
///
///   dermis::AssetArrays head;
///   head.name = "hero";
///   head.images = {{.name = "colour", .width = 2048, .height = 2048, .channels = 3, .pixels = rgb}};
///   head.materials.resize(1);
///   head.materials[0].name = "face";
///   head.materials[0].skin = true;
///   head.materials[0].base_colour_map.image = 0;
///   head.meshes = {{.name = "face", .material = 0, .positions_m = points, .uv0 = uvs, .indices =
///   triangles}};
///
/// Spans are borrowed, and read only while the call that takes the AssetArrays runs; what dermis keeps, it
/// copies. That call throws InputError, one line that names asset, object and member, for whatever is out of
/// the ranges below; nothing is allocated before all is checked. Numbers are finite unless a comment says
/// otherwise.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dermis/profile.h"

namespace dermis {

/// Triangles of one material; its number (dermis/asset.h) is its place in AssetArrays::meshes. Per vertex:
/// `positions_m`, and the other attributes that are not empty, which have as many elements.
struct AssetMesh {
  std::string name;   ///< for messages
  int material = -1;  ///< index into AssetArrays::materials; -1: white metal, glTF's default
  /// Meshes of skin with the same number are one head: they share an unwrap, and light spreads from one to
  /// the other. -1 to 1,000,000; -1: a head of its own. Without a meaning for what is not skin.
  int node = -1;
  /// m, right-handed, +Y up, at most 1e6 m from the origin once SceneOptions::unit_scale is applied; a head
  /// is 0.1 to 0.6 m high, because light spreads by mm.
  std::span<const std::array<float, 3>> positions_m{};
  /// Of any length. One that is 0 or not finite is computed: smooth, weighted by area. Empty: all are.
  std::span<const std::array<float, 3>> normals{};
  /// x, y, z of any length but 0, and w, -1 or 1: bitangent = w * cross(normal, tangent), for the coordinates
  /// of the normal map. Empty, without normals, one that is none of this, or a normal or displacement map
  /// with a transform: all are computed from the coordinates.
  std::span<const std::array<float, 4>> tangents{};
  /// Texture coordinates, v down: (0, 0) is the corner of the image's first texel. Within -1e5 to 1e5. Skin
  /// without uv0 is lit without scattering; maps whose coordinates are missing are left out for this mesh,
  /// both with a warning.
  std::span<const std::array<float, 2>> uv0{}, uv1{};
  /// Linear RGBA, multiplies the base colour; clamped to 0..1. Empty: white.
  std::span<const std::array<float, 4>> colours{};
  /// Three per triangle, counter-clockwise seen from outside, below the number of vertices. Empty: each three
  /// vertices are a triangle. At least one triangle; at most 20,000,000 in all meshes. Vertices that no
  /// triangle uses are dropped.
  std::span<const std::uint32_t> indices{};
};

/// A map beyond its border.
enum class AssetWrap : std::uint8_t { repeat, clamp, mirror };

/// An image on a mesh.
struct AssetMap {
  int image = -1;  ///< index into AssetArrays::images; -1: no map
  int uv_set = 0;  ///< 0: AssetMesh::uv0, 1: AssetMesh::uv1
  /// From the mesh's coordinates to the image's: (u, v) becomes u * [0] + v * [1] + [2].
  std::array<std::array<float, 2>, 3> transform{{{1, 0}, {0, 1}, {0, 0}}};
  AssetWrap wrap_u = AssetWrap::repeat;
  AssetWrap wrap_v = AssetWrap::repeat;
  bool nearest = false;  ///< magnified without interpolation
};

/// One channel of a map, times a factor.
struct AssetChannelMap {
  AssetMap map{};
  int channel = 0;  ///< 0 to 3: red, green, blue, alpha
  float scale = 1;  ///< 0 to 1000
};

/// One lobe of the reflection at the skin's surface.
struct AssetLobe {
  float roughness_factor = 1;  ///< above 0, to 100; multiplies roughness^2
  float weight = 1;            ///< 0 to 1
};

/// Properties of skin beside AssetMaterial; `extras.dermis` of a file.
struct AssetSkin {
  std::optional<ScatterProfile> profile{};  ///< none: the published six Gaussians
  /// 0 to 1: how much of the colour acts before light scatters, the rest after; none: 0.5. 0 for photographs.
  std::optional<float> mix{};
  AssetChannelMap specular{};           ///< multiplies the strength of the reflection
  AssetChannelMap roughness{{}, 1, 1};  ///< glTF roughness, in green; no map: AssetMaterial::roughness
  AssetMap displacement{};              ///< heights in red, become fine normals
  float displacement_mm = 0;            ///< from black to white, 0 to 100
  float displacement_middle = 0.5f;     ///< the value of no height, 0 to 1
  /// Normals finer than the normal map, in its tangent space: a tile, repeated by its transform.
  AssetMap detail{};
  float detail_scale = 1;  ///< multiplies its slopes, 0 to 10
  /// 1 or 2, weights summing to 1 within 1e-3. Empty: factors 0.75 and 1.3, weights 0.85 and 0.15.
  std::vector<AssetLobe> lobes{};
};

/// Use of the alpha of the base colour.
enum class AssetAlpha : std::uint8_t { opaque, mask, blend };

/// A metallic-roughness material of glTF 2.0. Colours and factors are linear.
struct AssetMaterial {
  std::string name;
  /// True: it is skin, unless SceneOptions::skin_material names one. none: it is if "skin" is a word of its
  /// name and no material says that it is. Also if it is the only material in use and no other is called
  /// skin. Skin that is blended is drawn as a surface, with a warning.
  std::optional<bool> skin{};
  std::array<float, 4> base_colour{1, 1, 1, 1};  ///< 0 to 1, with alpha
  AssetMap base_colour_map{};                    ///< sRGB, alpha linear
  float metallic = 1;                            ///< 0 to 1; glTF's default, which is seldom what is meant
  float roughness = 1;                           ///< 0 to 1
  AssetMap metallic_roughness_map{};             ///< roughness in green, metallic in blue
  AssetMap normal_map{};                         ///< tangent space, +Y up
  float normal_scale = 1;
  AssetMap occlusion_map{};         ///< red
  float occlusion_strength = 1;     ///< 0 to 1
  std::array<float, 3> emissive{};  ///< radiance, 0 to 1e6
  AssetMap emissive_map{};          ///< sRGB
  std::optional<float> ior{};       ///< 1 to 100; 0: Fresnel of 1 everywhere; none: 1.4 for skin, else 1.5
  float specular = 1;               ///< 0 to 1, KHR_materials_specular
  AssetMap specular_map{};          ///< alpha
  std::array<float, 3> specular_colour{1, 1, 1};  ///< 0 to 1e6
  AssetMap specular_colour_map{};                 ///< sRGB
  AssetAlpha alpha = AssetAlpha::opaque;
  float alpha_cutoff = 0.5f;  ///< of AssetAlpha::mask, 0 to 1e6
  bool double_sided = false;
  bool unlit = false;         ///< shows its base colour, whatever the light
  AssetSkin skin_settings{};  ///< of skin
};

/// 8 bits per channel. An image that no map of a mesh's material uses is not kept.
struct AssetImage {
  std::string name;           ///< for messages
  int width = 0, height = 0;  ///< pixels, 1 to 16384
  int channels = 4;           ///< 1: grey, 2: grey and alpha, 3: RGB, 4: RGBA
  /// width * height * channels values, rows from top to bottom, without gaps
  std::span<const std::uint8_t> pixels{};
};

/// All of it. The order of meshes and materials is kept; materials that no mesh uses are dropped.
struct AssetArrays {
  std::string name;  ///< for messages, and the name of the asset
  std::vector<AssetMesh> meshes{};
  std::vector<AssetMaterial> materials{};
  std::vector<AssetImage> images{};
};

}  // namespace dermis
