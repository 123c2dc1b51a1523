// SPDX-License-Identifier: MIT
#include "support.h"

#include <cstring>

#include "tissue/gaussians/scatter_profile.h"

namespace dermis::scene::test {

namespace {

AssetMap map_of(const MapRef& map) {
  AssetMap given;
  if (!map.present()) return given;
  given.image = map.image;
  given.uv_set = map.uv_set;
  for (glm::length_t column = 0; column < 3; ++column)
    given.transform[static_cast<std::size_t>(column)] = {map.transform[column][0], map.transform[column][1]};
  given.wrap_u = static_cast<AssetWrap>(map.wrap_u);
  given.wrap_v = static_cast<AssetWrap>(map.wrap_v);
  given.nearest = map.nearest;
  return given;
}

AssetSkin skin_of(const SkinMaterial& skin) {
  AssetSkin given;
  if (skin.profile) given.profile = *skin.profile;
  given.mix = skin.mix;
  given.specular = {map_of(skin.specular), skin.specular.channel, skin.specular.scale};
  given.roughness = {map_of(skin.roughness), skin.roughness.channel, skin.roughness.scale};
  given.displacement = map_of(skin.displacement);
  given.displacement_mm = skin.displacement_mm;
  given.displacement_middle = skin.displacement_middle;
  given.detail = map_of(skin.detail);
  given.detail_scale = skin.detail.scale;
  for (const SpecularLobe& lobe : skin.lobes) given.lobes.push_back({lobe.roughness_factor, lobe.weight});
  return given;
}

AssetMaterial material_of(const Material& m) {
  AssetMaterial given;
  given.name = m.name;
  given.skin = m.skin;
  given.base_colour = {m.base_colour.r, m.base_colour.g, m.base_colour.b, m.base_colour.a};
  given.base_colour_map = map_of(m.base_colour_map);
  given.metallic = m.metallic;
  given.roughness = m.roughness;
  given.metallic_roughness_map = map_of(m.metallic_roughness_map);
  given.normal_map = map_of(m.normal_map);
  given.normal_scale = m.normal_map.scale;
  given.occlusion_map = map_of(m.occlusion_map);
  given.occlusion_strength = m.occlusion_map.scale;
  given.emissive = {m.emissive.r, m.emissive.g, m.emissive.b};
  given.emissive_map = map_of(m.emissive_map);
  given.ior = m.ior;
  given.specular = m.specular;
  given.specular_map = map_of(m.specular_map);
  given.specular_colour = {m.specular_colour.r, m.specular_colour.g, m.specular_colour.b};
  given.specular_colour_map = map_of(m.specular_colour_map);
  given.alpha = static_cast<AssetAlpha>(m.alpha_mode);
  given.alpha_cutoff = m.alpha_cutoff;
  given.double_sided = m.double_sided;
  given.unlit = m.unlit;
  given.skin_settings = skin_of(m.skin_settings);
  return given;
}

OwnedMesh mesh_of(const Primitive& primitive, ArraysOf::Tangents tangents) {
  OwnedMesh mesh;
  bool second = false, coloured = false;
  for (const Vertex& v : primitive.vertices) {
    mesh.positions_m.push_back({v.position_m.x, v.position_m.y, v.position_m.z});
    mesh.normals.push_back({v.normal.x, v.normal.y, v.normal.z});
    mesh.tangents.push_back({v.tangent.x, v.tangent.y, v.tangent.z, v.tangent.w});
    mesh.colours.push_back({v.colour.r, v.colour.g, v.colour.b, v.colour.a});
    mesh.uv0.push_back({v.uv0.x, v.uv0.y});
    mesh.uv1.push_back({v.uv1.x, v.uv1.y});
    second |= v.uv1 != glm::vec2(0);
    coloured |= v.colour != glm::vec4(1);
  }
  mesh.indices = primitive.indices;

  if (tangents == ArraysOf::Tangents::none) mesh.tangents.clear();
  if (!primitive.has_uv) mesh.uv0.clear();
  if (!second) mesh.uv1.clear();
  if (!coloured) mesh.colours.clear();
  return mesh;
}

void expect_same_map(const MapRef& made, const MapRef& expected, const std::string& what) {
  ASSERT_EQ(made.present(), expected.present()) << what;
  if (!expected.present()) return;
  EXPECT_EQ(made.image, expected.image) << what;
  EXPECT_EQ(made.uv_set, expected.uv_set) << what;
  EXPECT_EQ(made.transform, expected.transform) << what;
  EXPECT_EQ(made.wrap_u, expected.wrap_u) << what;
  EXPECT_EQ(made.wrap_v, expected.wrap_v) << what;
  EXPECT_EQ(made.nearest, expected.nearest) << what;
  EXPECT_EQ(made.channel, expected.channel) << what;
  EXPECT_EQ(made.scale, expected.scale) << what;
}

void expect_same_skin(const SkinMaterial& made, const SkinMaterial& expected, const std::string& name) {
  EXPECT_EQ(made.profile, expected.profile) << name;
  EXPECT_EQ(made.mix, expected.mix) << name;
  EXPECT_EQ(made.displacement_mm, expected.displacement_mm) << name;
  EXPECT_EQ(made.displacement_middle, expected.displacement_middle) << name;
  ASSERT_EQ(made.lobes.size(), expected.lobes.size()) << name;
  for (std::size_t i = 0; i < made.lobes.size(); ++i) {
    EXPECT_EQ(made.lobes[i].roughness_factor, expected.lobes[i].roughness_factor) << name;
    EXPECT_EQ(made.lobes[i].weight, expected.lobes[i].weight) << name;
  }
}

void expect_same_material(const Material& made, const Material& expected) {
  const std::string& name = expected.name;
  EXPECT_EQ(made.name, expected.name);
  EXPECT_EQ(made.skin, expected.skin) << name;
  EXPECT_EQ(made.base_colour, expected.base_colour) << name;
  EXPECT_EQ(made.metallic, expected.metallic) << name;
  EXPECT_EQ(made.roughness, expected.roughness) << name;
  EXPECT_EQ(made.emissive, expected.emissive) << name;
  EXPECT_EQ(made.ior, expected.ior) << name;
  EXPECT_EQ(made.specular, expected.specular) << name;
  EXPECT_EQ(made.specular_colour, expected.specular_colour) << name;
  EXPECT_EQ(made.alpha_mode, expected.alpha_mode) << name;
  EXPECT_EQ(made.alpha_cutoff, expected.alpha_cutoff) << name;
  EXPECT_EQ(made.double_sided, expected.double_sided) << name;
  EXPECT_EQ(made.unlit, expected.unlit) << name;

  expect_same_map(made.base_colour_map, expected.base_colour_map, name + " base_colour_map");
  expect_same_map(made.metallic_roughness_map, expected.metallic_roughness_map, name + " metallic_roughness");
  expect_same_map(made.normal_map, expected.normal_map, name + " normal_map");
  expect_same_map(made.occlusion_map, expected.occlusion_map, name + " occlusion_map");
  expect_same_map(made.emissive_map, expected.emissive_map, name + " emissive_map");
  expect_same_map(made.specular_map, expected.specular_map, name + " specular_map");
  expect_same_map(made.specular_colour_map, expected.specular_colour_map, name + " specular_colour_map");
  const SkinMaterial &a = made.skin_settings, &b = expected.skin_settings;
  expect_same_map(a.specular, b.specular, name + " skin specular");
  expect_same_map(a.roughness, b.roughness, name + " skin roughness");
  expect_same_map(a.displacement, b.displacement, name + " displacement");
  expect_same_map(a.detail, b.detail, name + " detail");
  expect_same_skin(a, b, name);
}

void expect_same_primitive(const Primitive& made, const Primitive& expected, float directions) {
  const std::string& name = expected.name;
  EXPECT_EQ(made.name, expected.name);
  EXPECT_EQ(made.material, expected.material) << name;
  EXPECT_EQ(made.node, expected.node) << name;
  EXPECT_EQ(made.has_uv, expected.has_uv) << name;
  EXPECT_EQ(made.indices, expected.indices) << name;
  ASSERT_EQ(made.vertices.size(), expected.vertices.size()) << name;

  int different = 0;
  float off = 0;
  for (std::size_t i = 0; i < made.vertices.size(); ++i) {
    Vertex a = made.vertices[i];
    const Vertex& b = expected.vertices[i];
    for (glm::length_t k = 0; k < 4; ++k) off = std::max(off, std::abs(a.tangent[k] - b.tangent[k]));
    for (glm::length_t k = 0; k < 3; ++k) off = std::max(off, std::abs(a.normal[k] - b.normal[k]));
    if (directions > 0) {
      a.normal = b.normal;
      a.tangent = b.tangent;
    }
    different += std::memcmp(&a, &b, sizeof a) != 0 ? 1 : 0;
  }
  static_assert(sizeof(Vertex) == 18 * sizeof(float), "no padding");
  EXPECT_EQ(different, 0) << name << ": vertices of " << made.vertices.size();
  EXPECT_LE(off, directions) << name;
}

}  // namespace

void OwnedMesh::lend(AssetMesh& mesh) const {
  mesh.positions_m = positions_m;
  mesh.normals = normals;
  mesh.tangents = tangents;
  mesh.uv0 = uv0;
  mesh.uv1 = uv1;
  mesh.colours = colours;
  mesh.indices = indices;
}

ArraysOf::ArraysOf(const AssetData& scene, Tangents tangents) {
  given.name = scene.name;
  for (const Primitive& primitive : scene.primitives) {
    AssetMesh& mesh = given.meshes.emplace_back();
    mesh.name = primitive.name;
    mesh.material = primitive.material;
    mesh.node = primitive.node;
    owned_.push_back(mesh_of(primitive, tangents));
    owned_.back().lend(mesh);
  }

  for (const Material& material : scene.materials) given.materials.push_back(material_of(material));
  for (const MapImage& image : scene.images)
    given.images.push_back({.name = image.name,
                            .width = image.pixels->width,
                            .height = image.pixels->height,
                            .channels = 4,
                            .pixels = image.pixels->rgba});
}

void expect_same(const AssetData& made, const AssetData& expected, float directions) {
  ASSERT_EQ(made.primitives.size(), expected.primitives.size());
  for (std::size_t i = 0; i < made.primitives.size(); ++i)
    expect_same_primitive(made.primitives[i], expected.primitives[i], directions);
  ASSERT_EQ(made.materials.size(), expected.materials.size());
  for (std::size_t i = 0; i < made.materials.size(); ++i)
    expect_same_material(made.materials[i], expected.materials[i]);

  ASSERT_EQ(made.images.size(), expected.images.size());
  for (std::size_t i = 0; i < made.images.size(); ++i) {
    EXPECT_EQ(made.images[i].name, expected.images[i].name);
    EXPECT_EQ(made.images[i].pixels->width, expected.images[i].pixels->width);
    EXPECT_EQ(made.images[i].pixels->height, expected.images[i].pixels->height);
    EXPECT_TRUE(made.images[i].pixels->rgba == expected.images[i].pixels->rgba) << made.images[i].name;
  }
  EXPECT_EQ(made.mm_per_unit, expected.mm_per_unit);
}

}  // namespace dermis::scene::test
