// SPDX-License-Identifier: MIT
// Real heads: the scan with a manifest of our own, the MakeHuman people, the ICT face, and the same head
// stored in many ways.
#include <cmath>
#include <set>

#include "head/scene/placement.h"
#include "support.h"
#include "support/written_out.h"

namespace dermis::scene::test {

namespace {

std::size_t triangles(const AssetData& scene) {
  std::size_t count = 0;
  for (const Primitive& p : scene.primitives) count += copies_of(p) * p.indices.size() / 3;
  return count;
}

struct Box {
  glm::vec3 low{1e9f}, high{-1e9f};
};
Box box(const AssetData& scene) {
  Box b;
  for (const Primitive& p : written_out(scene))
    for (const Vertex& v : p.vertices) {
      b.low = glm::min(b.low, v.position_m);
      b.high = glm::max(b.high, v.position_m);
    }
  return b;
}

void expect_sound(const AssetData& scene) {
  for (const Primitive& p : written_out(scene)) {
    ASSERT_FALSE(p.indices.empty());
    for (const std::uint32_t i : p.indices) ASSERT_LT(i, p.vertices.size());
    for (const Vertex& v : p.vertices) {
      ASSERT_NEAR(glm::length(v.normal), 1, 1e-4f) << p.name;
      ASSERT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-4f) << p.name;
      ASSERT_NEAR(glm::dot(v.normal, glm::vec3(v.tangent)), 0, 1e-3f) << p.name;
      ASSERT_EQ(std::abs(v.tangent.w), 1) << p.name;
    }
  }
}

/// Part of the area whose winding agrees with the vertex normals.
double outward_part(const AssetData& scene) {
  double good = 0, all = 0;
  for (const Primitive& p : written_out(scene))
    for (std::size_t i = 0; i < p.indices.size(); i += 3) {
      const Vertex &a = p.vertices[p.indices[i]], &b = p.vertices[p.indices[i + 1]],
                   &c = p.vertices[p.indices[i + 2]];
      const glm::vec3 face = glm::cross(b.position_m - a.position_m, c.position_m - a.position_m);
      const double area = glm::length(face);
      all += area;
      if (glm::dot(face, a.normal + b.normal + c.normal) > 0) good += area;
    }
  return good / all;
}

/// The largest distance of a corner in one scene to the corner at the same place in the list of the other.
float largest_difference_m(const AssetData& a, const AssetData& b) {
  float largest = 0;
  for (std::size_t p = 0; p < a.primitives.size(); ++p)
    for (std::size_t i = 0; i < a.primitives[p].indices.size(); ++i)
      largest =
          std::max(largest, glm::distance(a.primitives[p].vertices[a.primitives[p].indices[i]].position_m,
                                          b.primitives[p].vertices[b.primitives[p].indices[i]].position_m));
  return largest;
}

const Material& skin_of(const AssetData& scene) {
  for (const Material& m : scene.materials)
    if (m.skin) return m;
  throw std::runtime_error("no skin");
}

/// A manifest for the scan: its own buffer is the .glb file, coordinates flipped, extras.dermis in full.
Json scan_manifest() {
  const Json flip = {{"KHR_texture_transform", {{"scale", {1, -1}}, {"offset", {0, 1}}}}};
  const auto info = [&](int texture) { return Json{{"index", texture}, {"extensions", flip}}; };
  Json json = Json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "scale": [0.053, 0.053, 0.053], "name": "head"}],
    "meshes": [{"primitives": [{
      "attributes": {"POSITION": 1, "NORMAL": 2, "TEXCOORD_0": 3}, "indices": 0, "material": 0}]}],
    "buffers": [{"uri": "LeePerrySmith.glb", "byteLength": 404976}],
    "images": [{"uri": "Map-COL.jpg"}, {"uri": "Map-SPEC.jpg"}], "textures": [{"source": 0}, {"source": 1}],
    "extensionsUsed": ["KHR_texture_transform"]})");
  json["materials"] = Json::array(
      {{{"name", "face"},
        {"normalTexture", info(0)},
        {"pbrMetallicRoughness", {{"baseColorTexture", info(0)}, {"roughnessFactor", 0.55}}},
        {"extras", {{"dermis", {{"mix", 0}, {"specular", {{"texture", 1}, {"channel", "R"}}}}}}}}});
  return json;
}

/// Accessors and views of the .glb itself, moved behind its header and JSON.
void point_at_glb(Json& manifest, const fs::path& glb) {
  const std::string bytes = read_text(glb);
  const auto json_length = static_cast<unsigned char>(bytes[12]) | static_cast<unsigned char>(bytes[13]) << 8;
  const Json source = Json::parse(bytes.substr(20, json_length));
  const Json primitive = source["meshes"][0]["primitives"][0];
  const auto add = [&](int accessor) {
    Json a = source["accessors"][accessor], view = source["bufferViews"][a["bufferView"].get<int>()];
    view["byteOffset"] = view.value("byteOffset", 0) + 20 + json_length + 8;
    manifest["bufferViews"].push_back(view);
    a["bufferView"] = manifest["bufferViews"].size() - 1;
    manifest["accessors"].push_back(a);
  };
  add(primitive["indices"]);
  for (const char* semantic : {"POSITION", "NORMAL", "TEXCOORD_0"}) add(primitive["attributes"][semantic]);
}

}  // namespace

TEST(GltfHeads, ScanThroughAManifestThatReadsTheGlb) {
  DERMIS_NEED_ASSETS(root);
  const fs::path scan = *root / "lee-perry-smith";
  if (!fs::exists(scan / "LeePerrySmith.glb")) GTEST_SKIP() << "the scan is not in the asset cache";

  const TempFolder folder;
  for (const char* name : {"LeePerrySmith.glb", "Map-COL.jpg", "Map-SPEC.jpg"})
    fs::copy_file(scan / name, folder.path() / name);
  Json manifest = scan_manifest();
  point_at_glb(manifest, scan / "LeePerrySmith.glb");
  write_text(folder.path() / "head.gltf", manifest.dump());

  const Warnings warnings;
  const AssetData scene = load_gltf(folder.path() / "head.gltf");
  EXPECT_EQ(warnings.all(), "");
  expect_sound(scene);
  EXPECT_EQ(triangles(scene), 17684u);
  EXPECT_NEAR(box(scene).high.y - box(scene).low.y, 0.4211f, 1e-3f);
  EXPECT_GT(outward_part(scene), 0.999);

  const Material& skin = skin_of(scene);
  EXPECT_EQ(skin.ior, 1.4f);
  EXPECT_EQ(skin.skin_settings.mix, 0.0f);
  ASSERT_TRUE(skin.skin_settings.specular.present());
  // Named by number: the map takes over the coordinates of the colour map.
  EXPECT_EQ(skin.skin_settings.specular.transform, skin.base_colour_map.transform);
  EXPECT_EQ(skin.base_colour_map.transform, glm::mat3x2(1, 0, 0, -1, 0, 1));
  EXPECT_EQ(scene.images.size(), 2u);  // the colour picture is used twice and decoded once
  EXPECT_EQ(scene.images[0].pixels->width, 1024);

  // README of the assets: the nose tip, the foremost vertex, has v = 0.613 in the file.
  const Vertex* nose = &scene.primitives[0].vertices[0];
  for (const Vertex& v : scene.primitives[0].vertices)
    if (v.position_m.z > nose->position_m.z) nose = &v;
  EXPECT_NEAR(nose->uv0.y, 0.613f, 5e-3f);
}

TEST(GltfHeads, ScanWithoutManifestWarnsOfItsSize) {
  DERMIS_NEED_ASSETS(root);
  const fs::path file = *root / "lee-perry-smith" / "LeePerrySmith.glb";
  {
    const Warnings warnings;
    const AssetData scene = load_gltf(file);
    EXPECT_TRUE(warnings.any_with("7.945 m high")) << warnings.all();
    EXPECT_TRUE(warnings.any_with("unit_scale"));
    EXPECT_TRUE(scene.materials[0].skin);  // the only material
  }
  const Warnings warnings;
  LoadOptions metres;
  metres.unit_scale = 0.053;
  EXPECT_NEAR(box(load_gltf(file, metres)).high.y, 3.973f * 0.053f, 1e-3f);
  EXPECT_EQ(warnings.all(), "");
}

TEST(GltfHeads, MakeHumanPeopleAreWholeCharacters) {
  DERMIS_NEED_ASSETS(root);
  for (const char* name : {"mh-african-man-young.glb", "mh-asian-woman-young-sub1.glb"}) {
    const Warnings warnings;
    const AssetData scene = load_gltf(*root / "makehuman" / name);
    EXPECT_EQ(warnings.all(), "") << name;
    expect_sound(scene);
    ASSERT_EQ(scene.materials.size(), 4u);
    for (const Material& m : scene.materials) {
      EXPECT_EQ(m.skin, m.name == "skin");
      EXPECT_TRUE(m.base_colour_map.present()) << m.name;
      EXPECT_EQ(m.alpha_mode != AssetAlpha::opaque, m.name == "brow" || m.name == "lash") << m.name;
    }
    EXPECT_EQ(scene.images[skin_of(scene).base_colour_map.image].pixels->width, 2048);
    EXPECT_GT(outward_part(scene), 0.99) << name;
  }
}

TEST(GltfHeads, IctFaceIsSoundWithoutMaps) {
  DERMIS_NEED_ASSETS(root);
  const Warnings warnings;
  const AssetData scene = load_gltf(*root / "ict-facekit" / "ict-mean-animated.glb");
  EXPECT_EQ(warnings.all(), "");
  expect_sound(scene);
  EXPECT_EQ(triangles(scene), 48836u);
  EXPECT_TRUE(scene.images.empty());
  EXPECT_EQ(skin_of(scene).name, "skin");
}

TEST(GltfHeads, CompressedAndQuantizedHeadsAreTheSameHead) {
  DERMIS_NEED_ASSETS(root);
  const fs::path variants = *root / "gltf-valid" / "head-variants";
  const Warnings quiet;
  const AssetData plain = load_gltf(*root / "makehuman" / "mh-asian-woman-young.glb");
  const AssetData quantized = load_gltf(variants / "head-anim-quantized.glb");
  const AssetData meshopt = load_gltf(variants / "head-anim-meshopt-quantized.glb");
  const AssetData embedded = load_gltf(variants / "head-embedded-datauri.gltf");
  const AssetData draco = load_gltf(variants / "head-draco.glb");

  for (const AssetData* s : {&quantized, &meshopt, &embedded, &draco}) expect_sound(*s);
  ASSERT_EQ(triangles(quantized), triangles(plain));
  ASSERT_EQ(triangles(meshopt), triangles(plain));

  // 16 bits over 0.3 m are 5 um.
  for (const AssetData* s : {&quantized, &meshopt}) {
    EXPECT_NEAR(glm::distance(box(*s).low, box(plain).low), 0, 2e-5f);
    EXPECT_NEAR(glm::distance(box(*s).high, box(plain).high), 0, 2e-5f);
  }

  EXPECT_EQ(triangles(draco), triangles(embedded));
  EXPECT_NEAR(glm::distance(box(draco).low, box(embedded).low), 0, 2e-4f);
  EXPECT_NEAR(glm::distance(box(draco).high, box(embedded).high), 0, 2e-4f);
  EXPECT_GT(outward_part(draco), 0.99);
}

TEST(GltfHeads, NamesWithSpacesAndUnicodeAreFound) {
  DERMIS_NEED_ASSETS(root);
  const fs::path folder = *root / "gltf-valid" / "head-variants" / "unicode and spaces";
  const Warnings quiet;
  const AssetData escaped = load_gltf(folder / "t\u00eate \u982d.gltf");
  const AssetData plain = load_gltf(folder / "unescaped-uris.gltf");
  EXPECT_EQ(escaped.images.size(), 2u);
  EXPECT_EQ(largest_difference_m(escaped, plain), 0);
}

TEST(GltfHeads, MirroredInstancesAreWoundOutwards) {
  DERMIS_NEED_ASSETS(root);
  const Warnings quiet;
  const AssetData scene =
      load_gltf(*root / "gltf-valid" / "head-variants" / "head-instanced-mirrored-deep.glb");
  expect_sound(scene);
  const std::vector<Primitive> all = written_out(scene);
  EXPECT_EQ(all.size(), 8u);
  EXPECT_GT(outward_part(scene), 0.99);
  std::set<int> nodes;
  for (const Primitive& p : all) nodes.insert(p.node);
  EXPECT_EQ(nodes.size(), 4u);
}

TEST(GltfHeads, MissingNormalsAreMade) {
  DERMIS_NEED_ASSETS(root);
  const Warnings quiet;
  const AssetData scene = load_gltf(*root / "gltf-valid" / "head-variants" / "head-no-normals.glb");
  expect_sound(scene);
  EXPECT_GT(outward_part(scene), 0.99);
}

TEST(GltfHeads, LightsAndCameraStandInTheWorld) {
  DERMIS_NEED_ASSETS(root);
  const Warnings quiet;
  const AssetData scene =
      load_gltf(*root / "gltf-valid" / "head-variants" / "head-lights-camera-specular-ior.glb");
  ASSERT_EQ(scene.lights.size(), 3u);
  ASSERT_EQ(scene.cameras.size(), 1u);
  for (const Light& light : scene.lights) EXPECT_NEAR(glm::length(light.direction), 1, 1e-5f);
  const glm::mat3 r(scene.cameras[0].world_from_camera);
  EXPECT_NEAR(glm::determinant(r), 1, 1e-5f);
}

TEST(GltfHeads, TextureTransformsAreThoseOfItsTestModel) {
  DERMIS_NEED_ASSETS(root);
  const Warnings quiet;
  const AssetData scene =
      load_gltf(*root / "gltf-valid" / "assimp" / "textureTransform" / "TextureTransformTest.gltf");
  for (const Material& m : scene.materials) {
    // Where the model's "correct" marks stand on the quads (their nodes), the arrow's picture must be on its
    // diagonal.
    const glm::mat3x2& t = m.base_colour_map.transform;
    if (m.name == "Rotation") {
      const glm::vec2 uv = t * glm::vec3(0.5f - 0.07904822f, 0.5f + 0.51626749f, 1);
      EXPECT_NEAR(uv.x, uv.y, 1e-3f);
    }
    if (m.name == "Offset U") { EXPECT_EQ(t * glm::vec3(0, 0, 1), glm::vec2(0.5f, 0)); }
    if (m.name == "Scale") { EXPECT_EQ(t * glm::vec3(0.5f, 0.5f, 1), glm::vec2(0.75f, 0.75f)); }
  }
}

}  // namespace dermis::scene::test
