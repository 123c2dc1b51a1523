// SPDX-License-Identifier: MIT
// Maps whose texture coordinates a mesh lacks are left out for that mesh alone.
#include <array>

#include "support.h"

namespace dermis::scene::test {

namespace {

/// Triangles of one material with a colour map of set 0 and an occlusion map of set 1; for each, whether it
/// has the two sets.
Builder triangles(const std::vector<std::array<bool, 2>>& has_uv, const std::string& name) {
  Builder b;
  const int position = b.accessor({0, 0, 0, 0.2f, 0, 0, 0, 0.2f, 0}, "VEC3");
  const int uv = b.accessor({0, 0, 1, 0, 0, 1}, "VEC2");
  for (const auto& [first, second] : has_uv) {
    Json attributes = {{"POSITION", position}};
    if (first) attributes["TEXCOORD_0"] = uv;
    if (second) attributes["TEXCOORD_1"] = uv;
    b.json["meshes"][static_cast<std::size_t>(b.mesh(attributes))]["primitives"][0]["material"] = 0;
  }
  b.json["images"] = Json::array({{{"uri", one_pixel}}});
  b.json["textures"] = Json::array({{{"source", 0}}});
  b.json["materials"] = {{{"name", name},
                          {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                          {"occlusionTexture", {{"index", 0}, {"texCoord", 1}}},
                          {"extras", {{"dermis", {{"skin", name == "skin"}}}}}}};
  return b;
}

const Material& material_of(const AssetData& scene, std::size_t primitive) {
  return scene.materials.at(static_cast<std::size_t>(scene.primitives.at(primitive).material));
}

}  // namespace

TEST(GltfMissingUv, AMeshKeepsTheMapsThatItHasCoordinatesFor) {
  for (const std::string name : {"skin", "cloth"}) {
    const std::vector<std::array<bool, 2>> has_uv{{false, false}, {true, true}, {true, false}, {false, true}};
    const Warnings warnings;
    const AssetData scene = triangles(has_uv, name).load();
    ASSERT_EQ(scene.primitives.size(), has_uv.size());
    EXPECT_EQ(scene.materials.size(), 4u);
    for (std::size_t i = 0; i < has_uv.size(); ++i) {
      const Material& material = material_of(scene, i);
      EXPECT_EQ(material.base_colour_map.present(), has_uv[i][0]) << i;
      EXPECT_EQ(material.occlusion_map.present(), has_uv[i][1]) << i;
      EXPECT_EQ(material.name, name);
      EXPECT_EQ(material.skin, name == "skin");
    }
    EXPECT_TRUE(warnings.any_with("left out")) << warnings.all();
  }
}

TEST(GltfMissingUv, MapsThatNobodyCanReadAreNotRead) {
  const Warnings quiet;
  const AssetData scene = triangles({{false, false}, {false, false}}, "cloth").load();
  EXPECT_EQ(scene.materials.size(), 1u);
  EXPECT_TRUE(scene.images.empty());
}

TEST(GltfMissingUv, CoordinatesAtOnePointOrOnALineAreNone) {
  for (const std::vector<float>& uv :
       {std::vector<float>{.5f, .5f, .5f, .5f, .5f, .5f}, {0, 0, 1, 1, .5f, .5f}}) {
    Builder b = triangles({{true, true}}, "skin");
    b.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = b.accessor(uv, "VEC2");
    const Warnings warnings;
    b.load();
    EXPECT_TRUE(warnings.any_with("texture coordinates without area, so skin is lit without scattering"))
        << warnings.all();
  }
}

TEST(GltfMissingUv, NothingChangesWhereNothingIsMissing) {
  const Warnings warnings;
  const AssetData scene = triangles({{true, true}, {true, true}}, "skin").load();
  EXPECT_EQ(scene.materials.size(), 1u);
  EXPECT_FALSE(warnings.any_with("left out")) << warnings.all();
}

}  // namespace dermis::scene::test
