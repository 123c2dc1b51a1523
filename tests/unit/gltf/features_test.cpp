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
  const AssetData scene = b.load(options);
  expect_near(scene.primitives[0].vertices[0].position_m, {0, 0.1f, 0.5f});
  expect_near(scene.primitives[0].vertices[1].position_m, {0, 0.12f, 0.5f});
}

TEST(GltfNodes, PlacesAreNeededWhereSomethingIsShownBelow) {
  Builder b;
  b.triangle();
  b.json["nodes"].push_back({{"matrix", {1, 2, 3}}});
  b.json["scenes"][0]["nodes"] = {0, 1};
  const Warnings warnings;
  EXPECT_EQ(b.error(), "");
  EXPECT_TRUE(warnings.any_with("nodes[1]: has a place that cannot be read, and that nothing shown needs"))
      << warnings.all();
  b.json["nodes"][1]["children"] = {0};
  b.json["scenes"][0]["nodes"] = {1};
  EXPECT_ERROR(b.error(), "nodes[1].matrix");
  b.json["nodes"][1]["extensions"] = {{"KHR_node_visibility", {{"visible", false}}}};
  EXPECT_ERROR(b.error(), "there are no triangles");
}

TEST(GltfNodes, HiddenOnesAreLeftOutWithAllBelow) {
  Builder b;
  for (int i = 0; i < 3; ++i) b.triangle();
  b.json["scenes"][0]["nodes"] = {0, 1};
  b.json["nodes"][1]["children"] = {2};
  b.json["extensionsRequired"] = {"KHR_node_visibility"};
  b.json["nodes"][1]["extensions"] = {{"KHR_node_visibility", {{"visible", false}}}};
  EXPECT_EQ(b.load().primitives.size(), 1u);
  b.json["nodes"][1]["extensions"]["KHR_node_visibility"] = Json::object();
  EXPECT_EQ(b.load().primitives.size(), 3u);
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

// A joint without a matrix refuses what hangs on it, and no more.
TEST(GltfMesh, MatricesOfJointsAreNeededWhereVerticesHang) {
  Builder b;
  b.triangle();
  const int joints = b.accessor({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4", 5121);
  const int first = b.accessor({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4"),
            both = b.accessor({1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 1, 0, 0, 0}, "VEC4"),
            few = b.accessor({1, 0, 0, 0}, "VEC4");
  Json& attributes = b.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = joints;
  attributes["WEIGHTS_0"] = first;
  std::vector<float> bind;
  for (int i = 0; i < 16; ++i) bind.push_back(i % 5 == 0 ? 1.0f : 0.0f);
  const int one_matrix = b.accessor(bind, "MAT4");
  b.json["nodes"][0]["skin"] = 0;
  b.json["nodes"].push_back({{"translation", {0, 0, 2}}});
  b.json["nodes"].push_back(Json::object());
  b.json["skins"] = Json::array({{{"joints", {1, 2}}, {"inverseBindMatrices", one_matrix}}});
  expect_near(b.load().primitives[0].vertices[1].position_m, {0.2f, 0, 2});
  attributes["WEIGHTS_0"] = both;
  EXPECT_ERROR(b.error(),
               "vertices hang on joint 1 of their skin, which is no node, or whose inverse bind matrix");

  // Weights that cannot be read refuse the mesh where the node has a skin.
  attributes["WEIGHTS_0"] = few;
  EXPECT_ERROR(b.error(), "WEIGHTS_0 has 1 elements, others have 3");
  b.json["nodes"][0].erase("skin");
  EXPECT_EQ(b.error(), "");
}

}  // namespace dermis::scene::test
