// SPDX-License-Identifier: MIT
// One feature at a time, on files built in memory.
#include <cmath>

#include "support.h"
#include "support/log_lines.h"

namespace dermis::scene::test {

namespace {

glm::vec3 face_normal(const Primitive& p, std::size_t triangle = 0) {
  const glm::vec3 a = p.vertices[p.indices[triangle * 3]].position_m,
                  b = p.vertices[p.indices[triangle * 3 + 1]].position_m,
                  c = p.vertices[p.indices[triangle * 3 + 2]].position_m;
  return glm::normalize(glm::cross(b - a, c - a));
}

void add_texture(Builder& b) {
  b.json["images"] = Json::array({{{"uri", one_pixel}}});
  b.json["textures"] = Json::array({{{"source", 0}}});
}

/// A triangle whose one material is `material`.
Builder with_material(const Json& material) {
  Builder b;
  b.triangle();
  add_texture(b);
  b.json["materials"] = Json::array({material});
  Json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  primitive["attributes"]["TEXCOORD_1"] = Json(primitive["attributes"]["TEXCOORD_0"]);
  return b;
}

}  // namespace

TEST(GltfNodes, MirrorFlipsWindingAndTangents) {
  for (const bool mirrored : {false, true}) {
    Builder b;
    b.triangle();
    const int normal = b.accessor({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3"),
              tangent = b.accessor({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4");
    b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normal;
    b.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = tangent;
    if (mirrored) b.json["nodes"][0]["scale"] = {-1, 1, 1};
    const Primitive p = b.load().primitives[0];
    expect_near(face_normal(p), {0, 0, 1});
    for (const Vertex& v : p.vertices) {
      expect_near(v.normal, {0, 0, 1});
      expect_near(glm::vec3(v.tangent), {mirrored ? -1 : 1, 0, 0});
      // The picture's up direction stays +y in both: cross(n, t) turns with t, so w turns too.
      expect_near(glm::cross(v.normal, glm::vec3(v.tangent)) * v.tangent.w, {0, 1, 0});
    }
  }
}

TEST(GltfNodes, NonUniformScaleKeepsNormalsAcross) {
  Builder b;
  const float s = std::sqrt(0.5f);
  const int position = b.accessor({0, 0, 0, 1, 0, 0, 0, 1, -1}, "VEC3"),
            normal = b.accessor({0, s, s, 0, s, s, 0, s, s}, "VEC3");
  b.mesh({{"POSITION", position}, {"NORMAL", normal}});
  b.json["nodes"][0]["scale"] = {1, 3, 0.5};
  const Primitive p = b.load().primitives[0];
  expect_near(p.vertices[0].normal, face_normal(p));
}

TEST(GltfNodes, HierarchyAndUnitScale) {
  Builder b;
  b.triangle();
  b.json["nodes"][0]["translation"] = {1, 0, 0};
  b.json["nodes"].push_back(
      {{"children", {0}}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}, {"translation", {0, 0, 5}}});
  b.json["scenes"][0]["nodes"] = {1};
  LoadOptions options;
  options.unit_scale = 0.1;
  const Scene scene = b.load(options);
  expect_near(scene.primitives[0].vertices[0].position_m, {0, 0.1f, 0.5f});
  expect_near(scene.primitives[0].vertices[1].position_m, {0, 0.12f, 0.5f});
}

TEST(GltfNodes, OnlyTheShownSceneIsRead) {
  Builder b;
  b.triangle();
  b.triangle();
  b.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  b.json["nodes"][1]["name"] = "second";
  b.json["scene"] = 1;
  EXPECT_EQ(b.load().primitives[0].name, "second");
  EXPECT_EQ(b.load().primitives.size(), 1u);
  b.json.erase("scene");
  EXPECT_EQ(b.load().primitives[0].node, 0);
  b.json.erase("scenes");
  EXPECT_EQ(b.load().primitives.size(), 2u);
}

TEST(GltfNodes, AreAsDeepAsRigsHaveThem) {
  for (const int depth : {64, 65, 300, 20'000}) {
    Builder b;
    b.triangle();
    b.json["nodes"][0]["translation"] = {0, 0, 1};
    for (int i = 0; i < depth; ++i)
      b.json["nodes"].push_back({{"children", {i}}, {"translation", {0.25, 0, 0}}});
    b.json["scenes"][0]["nodes"] = {depth};
    expect_near(b.load({.unit_scale = 2}).primitives[0].vertices[0].position_m, {0.5f * float(depth), 0, 2});
  }
}

TEST(GltfNodes, LoopsAreOpened) {
  const Warnings warnings;
  Builder loop;
  loop.triangle();
  loop.json["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"children", {0}}}};
  EXPECT_EQ(loop.load().primitives.size(), 1u);

  Builder into_loop;
  into_loop.triangle();
  into_loop.json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1, 3}}}, Json::object()};
  EXPECT_EQ(into_loop.load().primitives.size(), 1u);
  EXPECT_TRUE(warnings.any_with("its own ancestor, and has no parent now"));
}

TEST(GltfMesh, StripsAndFansAreWoundAlike) {
  for (const int mode : {5, 6}) {
    Builder b;
    const std::vector<float> strip{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0},
        fan{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    b.mesh({{"POSITION", b.accessor(mode == 5 ? strip : fan, "VEC3")}});
    b.json["meshes"][0]["primitives"][0]["mode"] = mode;
    const Primitive p = b.load().primitives[0];
    ASSERT_EQ(p.indices.size(), 6u);
    for (const std::size_t t : {0, 1}) expect_near(face_normal(p, t), {0, 0, 1});
  }
}

TEST(GltfMesh, PointsAndLinesAreLeftOutWithAWarning) {
  Builder b;
  b.triangle();
  b.triangle();
  b.json["meshes"][1]["primitives"][0]["mode"] = 0;
  const Warnings warnings;
  EXPECT_EQ(b.load().primitives.size(), 1u);
  EXPECT_TRUE(warnings.any_with("points or lines"));
  b.json["meshes"][0]["primitives"][0]["mode"] = 1;
  EXPECT_ERROR(b.error(), "no triangles to draw");
}

TEST(GltfMesh, NormalisedIntegersAndAllIndexTypes) {
  for (const int index_type : {5121, 5123, 5125}) {
    Builder b;
    const int position = b.accessor({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    const int colour = b.accessor({255, 0, 51, 255, 255, 0, 51, 255, 255, 0, 51, 255}, "VEC4", 5121);
    const int uv = b.accessor({0, 65535, 0, 65535, 0, 65535}, "VEC2", 5123);
    for (const int a : {colour, uv}) b.json["accessors"][a]["normalized"] = true;
    const int indices = b.accessor({2, 0, 1}, "SCALAR", index_type);
    b.mesh({{"POSITION", position}, {"COLOR_0", colour}, {"TEXCOORD_0", uv}}, indices);
    const Primitive p = b.load().primitives[0];
    EXPECT_EQ(p.indices, (std::vector<std::uint32_t>{2, 0, 1}));
    EXPECT_EQ(p.vertices[0].colour, glm::vec4(1, 0, 0.2f, 1));
    EXPECT_EQ(p.vertices[0].uv0, glm::vec2(0, 1));
    EXPECT_TRUE(p.has_uv);
  }
}

TEST(GltfMesh, UnusedVerticesAreDropped) {
  Builder b;
  const int position = b.accessor({9, 9, 9, 0, 0, 0, 9, 9, 9, 1, 0, 0, 0, 1, 0}, "VEC3");
  b.mesh({{"POSITION", position}}, b.accessor({1, 3, 4}, "SCALAR", 5123));
  const Primitive p = b.load().primitives[0];
  ASSERT_EQ(p.vertices.size(), 3u);
  expect_near(p.vertices[p.indices[1]].position_m, {1, 0, 0});
}

TEST(GltfMesh, SparseValuesReplaceTheirBase) {
  Builder b;
  b.triangle();
  const int where = b.accessor({2}, "SCALAR", 5121), values = b.accessor({0, 7, 1}, "VEC3");
  b.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", b.json["accessors"][where]["bufferView"]}, {"componentType", 5121}}},
      {"values", {{"bufferView", b.json["accessors"][values]["bufferView"]}}}};
  expect_near(b.load().primitives[0].vertices[2].position_m, {0, 7, 1});
  b.json["accessors"][0].erase("bufferView");  // over zeros
  const Primitive zeros = b.load().primitives[0];
  expect_near(zeros.vertices[1].position_m, {0, 0, 0});
  expect_near(zeros.vertices[2].position_m, {0, 7, 1});
}

TEST(GltfMesh, InterleavedViews) {
  Builder b;
  b.accessor({0, 0, 0, 0.5f, 0.25f, 1, 0, 0, 0.5f, 0.25f, 0, 1, 0, 0.5f, 0.25f}, "SCALAR");
  b.json["bufferViews"][0]["byteStride"] = 20;
  b.json["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}},
      {{"bufferView", 0}, {"byteOffset", 12}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}}};
  b.mesh({{"POSITION", 0}, {"TEXCOORD_0", 1}});
  const Primitive p = b.load().primitives[0];
  expect_near(p.vertices[2].position_m, {0, 1, 0});
  EXPECT_EQ(p.vertices[2].uv0, glm::vec2(0.5f, 0.25f));
}

TEST(GltfMesh, MorphTargetsApplyAtTheirDefaultWeights) {
  Builder b;
  b.triangle();
  const int one = b.accessor({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3"),
            two = b.accessor({4, 0, 0, 4, 0, 0, 4, 0, 0}, "VEC3");
  b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", one}}, {{"POSITION", two}}};
  expect_near(b.load().primitives[0].vertices[0].position_m, {0, 0, 0});
  b.json["meshes"][0]["weights"] = {0.5, 0};
  expect_near(b.load().primitives[0].vertices[0].position_m, {0, 0, 0.5f});
  b.json["nodes"][0]["weights"] = {0, -0.25};
  expect_near(b.load().primitives[0].vertices[0].position_m, {-1, 0, 0});
}

TEST(GltfMesh, SkinsFollowTheirJointsAsTheyStand) {
  Builder b;
  b.triangle();
  const int joints = b.accessor({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4", 5121);
  // the last sums to 2: normalised
  const int weights = b.accessor({1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0, 2, 0, 0}, "VEC4");
  b.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = joints;
  b.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = weights;

  std::vector<float> bind;
  for (int joint = 0; joint < 2; ++joint)
    // joint 1 was bound at y = 1
    for (int i = 0; i < 16; ++i) bind.push_back(i % 5 == 0 ? 1.0f : i == 13 && joint == 1 ? -1.0f : 0.0f);

  b.json["nodes"][0]["skin"] = 0;
  b.json["nodes"][0]["translation"] = {100, 0, 0};  // ignored, as the specification says
  b.json["nodes"].push_back({{"translation", {0, 0, 2}}, {"children", {2}}});
  b.json["nodes"].push_back({{"translation", {0, 3, 0}}});
  b.json["scenes"][0]["nodes"].push_back(1);
  b.json["skins"] = Json::array({{{"joints", {1, 2}}, {"inverseBindMatrices", b.accessor(bind, "MAT4")}}});

  const Primitive p = b.load().primitives[0];
  expect_near(p.vertices[0].position_m, {0, 0, 2});
  expect_near(p.vertices[1].position_m, {0.2f, 1, 2});
  expect_near(p.vertices[2].position_m, {0, 2.2f, 2});

  // What hangs on a joint that is not there hangs on the others alone.
  b.json["skins"][0]["joints"] = {1};
  b.json["skins"][0].erase("inverseBindMatrices");
  const Warnings warnings;
  expect_near(b.load().primitives[0].vertices[1].position_m, {0.2f, 0, 2});
  EXPECT_TRUE(warnings.any_with("hang on joints which the skin does not have"));
}

TEST(GltfMaterial, FactorsMapsAndExtensions) {
  const Scene scene =
      with_material(
          Json::parse(R"({"name": "eye", "alphaMode": "MASK", "alphaCutoff": 0.3, "doubleSided": true,
    "pbrMetallicRoughness": {
      "baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5, "roughnessFactor": 0.25,
      "baseColorTexture": {"index": 0}},
    "normalTexture": {"index": 0, "scale": -2, "texCoord": 1},
    "occlusionTexture": {"index": 0, "strength": 0.5}, "emissiveFactor": [1, 0.5, 0],
    "extensions": {
      "KHR_materials_emissive_strength": {"emissiveStrength": 4},
      "KHR_materials_ior": {"ior": 1.33}, "KHR_materials_unlit": {},
      "KHR_materials_specular": {
        "specularFactor": 0.5, "specularColorFactor": [2, 1, 0], "specularTexture": {"index": 0}}}})"))
          .load();

  const Material& m = scene.materials[0];
  EXPECT_EQ(m.base_colour, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(m.metallic, 0.5f);
  EXPECT_EQ(m.roughness, 0.25f);
  EXPECT_EQ(m.normal_map.scale, -2);
  EXPECT_EQ(m.normal_map.uv_set, 1);
  EXPECT_EQ(m.occlusion_map.scale, 0.5f);
  EXPECT_EQ(m.emissive, glm::vec3(4, 2, 0));
  EXPECT_EQ(m.ior, 1.33f);
  EXPECT_EQ(m.specular, 0.5f);
  EXPECT_EQ(m.specular_colour, glm::vec3(2, 1, 0));
  EXPECT_EQ(m.specular_map.channel, 3);
  EXPECT_TRUE(m.unlit && m.double_sided && m.skin);
  EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(m.alpha_cutoff, 0.3f);

  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.images[0].pixels->rgba, (std::vector<std::uint8_t>{255, 0, 0, 127}));
}

// One line that names what is drawn as a surface although it would be skin; what is not used is not named.
TEST(GltfMaterial, BlendedSkinIsASurface) {
  Builder b;
  for (int i = 0; i < 3; ++i) {
    b.triangle();
    b.json["meshes"][i]["primitives"][0]["material"] = i;
  }
  b.json["materials"] = {{{"name", "skin A"}, {"alphaMode", "BLEND"}},
                         {{"name", "skin B"}, {"alphaMode", "MASK"}},
                         {{"name", "skin C"}, {"alphaMode", "BLEND"}},
                         {{"name", "skin D"}, {"alphaMode", "BLEND"}}};
  tests::LogLines said;
  const Scene scene = b.load();
  LoadOptions by_name;
  by_name.skin_material = "skin C";
  const Scene named = b.load(by_name);
  std::vector<std::string> lines = said.all;
  std::erase_if(lines, [](const std::string& line) { return line.find("BLEND") == std::string::npos; });

  EXPECT_FALSE(scene.materials[0].skin);
  EXPECT_TRUE(scene.materials[1].skin);
  EXPECT_FALSE(scene.materials[2].skin);
  EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::blend);
  EXPECT_EQ(scene.materials[0].ior, 1.5f) << "that of any surface";
  EXPECT_FALSE(named.materials[2].skin) << "--skin names what may be skin, not how it is drawn";
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].find("'skin A', 'skin C'"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("'skin C'"), std::string::npos) << lines[1];
}

TEST(GltfMaterial, SkinRule) {
  Builder b;
  for (int i = 0; i < 3; ++i) {
    b.triangle();
    b.json["meshes"][i]["primitives"][0]["material"] = i;
  }
  b.json["materials"] = {{{"name", "Eye"}}, {{"name", "FaceSkin"}}, {{"name", "Hair"}}};

  const auto skins = [](const Scene& s) {
    std::string names;
    for (const Material& m : s.materials) names += m.skin ? m.name + " " : "";
    return names;
  };
  EXPECT_EQ(skins(b.load()), "FaceSkin ");
  EXPECT_EQ(b.load().materials[1].ior, 1.4f);
  EXPECT_EQ(b.load().materials[0].ior, 1.5f);

  LoadOptions named;
  named.skin_material = "Hair";
  EXPECT_EQ(skins(b.load(named)), "Hair ");
  named.skin_material = "Nose";
  EXPECT_ERROR(b.error(named), "no material is called 'Nose'; there are: Eye, FaceSkin, Hair");

  b.json["materials"][0]["extras"] = {{"dermis", {{"skin", true}}}};
  EXPECT_EQ(skins(b.load()), "Eye ");
  b.json["materials"][0]["extras"] = {{"dermis", {{"skin", false}}}};
  EXPECT_EQ(skins(b.load()), "FaceSkin ");

  b.json["materials"][1]["name"] = "Face";
  const Warnings warnings;
  EXPECT_EQ(skins(b.load()), "");
  EXPECT_TRUE(warnings.any_with("no material is skin; name one with skin_material: 'Eye', 'Face', 'Hair'"))
      << warnings.all();
}

TEST(GltfMaterial, DermisExtrasAreReadInFull) {
  const SkinMaterial s = with_material(Json::parse(R"({"extras": {"dermis": {"skin": true, "mix": 0.25,
    "profile": {"name": "mine", "variances_mm2": [0.5, 2], "weights": [[0.5, 0.25, 1], [0.5, 0.75, 0]]},
    "specular": {"texture": 0, "channel": 1, "scale": 2},
    "roughness": {"texture": {"index": 0, "texCoord": 1}},
    "displacement": {"texture": 0, "mm": 3, "middle": 0.537},
    "detail": {"texture": {"index": 0, "texCoord": 1}, "scale": 0.5}, "lobes": [[1, 0.6], [2, 0.4]]}}})"))
                             .load()
                             .materials[0]
                             .skin_settings;

  ASSERT_TRUE(s.profile);
  EXPECT_EQ(s.profile->terms.size(), 2u);
  EXPECT_EQ(s.mix, 0.25f);
  EXPECT_EQ(s.specular.channel, 1);
  EXPECT_EQ(s.specular.scale, 2);
  EXPECT_EQ(s.roughness.channel, 1);  // green, as glTF has roughness
  EXPECT_EQ(s.roughness.uv_set, 1);

  EXPECT_EQ(s.displacement_mm, 3);
  EXPECT_EQ(s.displacement_middle, 0.537f);
  EXPECT_EQ(s.detail.image, 0);
  EXPECT_EQ(s.detail.uv_set, 1);
  EXPECT_EQ(s.detail.scale, 0.5f);
  ASSERT_EQ(s.lobes.size(), 2u);
  EXPECT_EQ(s.lobes[1].roughness_factor, 2);
}

TEST(GltfMaterial, DermisExtrasAreStrict) {
  const auto error = [](const std::string& dermis) {
    return with_material({{"extras", {{"dermis", Json::parse(dermis)}}}}).error();
  };

  EXPECT_ERROR(
      error(R"({"skinn": true})"),
      "unknown key 'skinn'; there are: skin, profile, mix, specular, roughness, displacement, detail, lobes");
  EXPECT_ERROR(error(R"({"specular": {"texture": 0, "chanel": 1}})"),
               "unknown key 'chanel'; there are: texture, channel, scale");
  EXPECT_ERROR(error(R"({"displacement": {"texture": 0}})"), "'mm' is missing");
  EXPECT_ERROR(error(R"({"specular": {"texture": 1}})"), "there is no texture 1");
  EXPECT_ERROR(error(R"({"detail": {"scale": 1}})"), "'texture' is missing");
  EXPECT_ERROR(error(R"({"detail": {"texture": 7}})"), "there is no texture 7");
  EXPECT_ERROR(error(R"({"detail": {"texture": 0, "scale": -1}})"), "must be 0 to 10");
  EXPECT_ERROR(error(R"({"specular": {"texture": 0, "channel": "X"}})"), "one of R, G, B, A");

  EXPECT_ERROR(error(R"({"mix": 1.5})"), "must be 0 to 1");
  EXPECT_ERROR(error(R"({"lobes": [[1, 0.5], [2, 0.4]]})"), "must sum to 1");
  EXPECT_ERROR(error(R"({"lobes": [[0, 1]]})"), "must be over 0");
  EXPECT_ERROR(error(R"({"lobes": []})"), "empty array");

  EXPECT_ERROR(error(R"({"profile": "no-such-skin"})"), "there are:");
  EXPECT_ERROR(error(R"({"profile": "/etc/passwd"})"), "relative to the scene");
  EXPECT_ERROR(error(R"({"profile": {"name": "x", "variances_mm2": [-1], "weights": [[1, 1, 1]]}})"),
               "extras.dermis.profile");
  EXPECT_ERROR(error(R"([])"), "must be an object");
}

TEST(GltfMaterial, ProfileFileLiesBesideTheScene) {
  const TempFolder folder;
  write_text(folder.path() / "mine.json",
             R"({"name": "mine", "variances_mm2": [1], "weights": [[1, 1, 1]]})");
  const Builder b = with_material({{"extras", {{"dermis", {{"profile", "mine.json"}}}}}});
  EXPECT_EQ(load_gltf(b.write(folder.path())).materials[0].skin_settings.profile->name, "mine");
}

TEST(GltfMaterial, FileTangentsServeOnlyAPlainNormalMap) {
  // Tangents along -x, against what the coordinates say: +x means that they were made anew.
  const auto tangent_x = [](const Json& normal_texture, float w) {
    Builder b = with_material({{"normalTexture", normal_texture}});
    b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        b.accessor({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    b.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] =
        b.accessor({-1, 0, 0, w, -1, 0, 0, w, -1, 0, 0, w}, "VEC4");
    return b.load().primitives[0].vertices[0].tangent;
  };
  EXPECT_EQ(tangent_x({{"index", 0}}, 1).x, -1);
  EXPECT_EQ(tangent_x({{"index", 0}}, 0.3f).x, 1);  // no handedness: not usable
  const Json flip = {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {1, -1}}}}}}};
  const glm::vec4 flipped = tangent_x(flip, 1);
  EXPECT_EQ(flipped.x, 1);
  // v of the file runs along +y; flipped it runs along -y, so the picture's top is at +y and cross(n, t) = +y
  // agrees.
  EXPECT_EQ(flipped.w, 1);
}

TEST(GltfImages, PlainSourceStandsInForUnreadFormats) {
  Builder b = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  b.json["images"].push_back({{"uri", "missing.ktx2"}});
  b.json["textures"][0]["extensions"] = {{"KHR_texture_basisu", {{"source", 1}}}};
  b.json["extensionsUsed"] = {"KHR_texture_basisu"};
  EXPECT_EQ(b.load().images.size(), 1u);
  b.json["textures"][0].erase("source");
  const Warnings warnings;
  EXPECT_FALSE(b.load().materials[0].base_colour_map.present());
  EXPECT_TRUE(warnings.any_with("no PNG or JPEG picture"));
  b.json["extensionsRequired"] = {"KHR_texture_basisu"};
  EXPECT_ERROR(b.error(), "requires the extension KHR_texture_basisu");
}

TEST(GltfImages, OnlyUsedImagesAreDecodedAndBadOnesNamed) {
  Builder b = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  b.json["images"].push_back({{"uri", "nowhere.png"}});
  b.json["textures"].push_back({{"source", 1}});
  EXPECT_EQ(b.error(), "");
  b.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 1}};
  EXPECT_ERROR(b.error(), "nowhere.png");
  b.json["images"][1] = {{"uri", "data:image/png;base64,AAAA"}, {"name", "pores"}};
  EXPECT_ERROR(b.error(), "image 'pores'");
}

TEST(GltfUris, WhatIsReadAndWhatIsRefused) {
  const TempFolder folder;
  const auto error = [&](const std::string& uri) {
    Builder b;
    b.triangle();
    b.json["buffers"][0]["uri"] = uri;
    write_text(folder.path() / "a b%.bin", b.bytes);
    write_text(folder.path() / "plain.bin", b.bytes);
    fs::create_directories(folder.path() / "sub");
    write_text(folder.path() / "sub" / "built.gltf", b.json.dump());
    return error_of(folder.path() / "sub" / "built.gltf");
  };

  EXPECT_EQ(error("../plain.bin"), "");
  EXPECT_EQ(error("../a%20b%25.bin"), "");
  EXPECT_EQ(error("../a b%.bin"), "");  // not escaped, but there

  EXPECT_ERROR(error((folder.path() / "plain.bin").string()), "absolute path");
  EXPECT_ERROR(error("%2Fetc%2Fhostname"), "absolute path");
  EXPECT_ERROR(error("file:///etc/hostname"), "not a relative uri");
  EXPECT_ERROR(error("C:\\x.bin"), "not a relative uri");
  EXPECT_ERROR(error("http://example.com/x.bin"), "not a relative uri");

  EXPECT_ERROR(error("no.bin"), "no such file");
  EXPECT_ERROR(error(".."), "is a directory");
  EXPECT_ERROR(error(""), "the uri is empty");

  EXPECT_ERROR(error("data:application/octet-stream;base64,AAAA"), "cut off");
  EXPECT_ERROR(error("data:application/octet-stream;base64,A*AA"), "not valid base64");
  EXPECT_ERROR(error("data:application/octet-stream,AAAA"), "base64");
}

}  // namespace dermis::scene::test
