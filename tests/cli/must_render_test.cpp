// SPDX-License-Identifier: MIT
// Heads that are odd but whole: each gives a picture, with a warning where one helps.
#include <algorithm>

#include "cli/program.h"
#include "cli/tiny_gltf.h"
#include "support/assets.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class MustRender : public Program {
 protected:
  Result rendered(const std::string& gltf, const Arguments& more = {}) const {
    fs::remove(picture());
    Arguments arguments{file("head.gltf", gltf)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = render(arguments);
    expect_rendered(result);
    return result;
  }
};

// 1 x 1, grey 180.
constexpr unsigned char one_texel_bytes[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
    0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3a, 0x7e, 0x9b, 0x55, 0x00,
    0x00, 0x00, 0x0a, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0xd8, 0x02, 0x00, 0x00, 0xb6, 0x00, 0xb5,
    0xb5, 0x2e, 0x5f, 0x69, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
const std::string one_texel(std::begin(one_texel_bytes), std::end(one_texel_bytes));

TEST_F(MustRender, AHeadWithoutMaps) { EXPECT_EQ(rendered(tiny_gltf()).err, ""); }

TEST_F(MustRender, MapsOfOneTexel) {
  rendered(tiny_gltf({}, [](json& root) {
    root["images"] = {{{"uri", data_uri("image/png", one_texel)}}};
    root["textures"] = {{{"source", 0}}};
    json& material = root["materials"][0];
    material["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 0}}},
                                        {"metallicRoughnessTexture", {{"index", 0}}}};
    material["normalTexture"] = {{"index", 0}};
    material["occlusionTexture"] = {{"index", 0}};
  }));
}

TEST_F(MustRender, DegenerateTriangles) {
  TinyMesh mesh;
  mesh.indices.insert(mesh.indices.end(), {0, 0, 0, 1, 1, 2, 0, 1, 2});  // a point, an edge, three on a line
  rendered(tiny_gltf(mesh));
}

TEST_F(MustRender, DegenerateTextureTriangles) {
  TinyMesh mesh;
  for (std::size_t i = 0; i < 40; ++i) mesh.uvs[i] = 0.5f;
  rendered(tiny_gltf(mesh));
  for (float& uv : mesh.uvs) uv = 0.25f;  // the whole head on one texel
  rendered(tiny_gltf(mesh));
}

TEST_F(MustRender, WithoutNormals) {
  TinyMesh mesh;
  mesh.normals.clear();
  rendered(tiny_gltf(mesh));
}

TEST_F(MustRender, WithoutTextureCoordinates) {
  TinyMesh mesh;
  mesh.uvs.clear();
  EXPECT_NE(rendered(tiny_gltf(mesh)).err.find("warning"), std::string::npos);
}

TEST_F(MustRender, WithoutIndices) {
  TinyMesh mesh;
  mesh.indices.clear();  // 81 vertices, 27 triangles
  rendered(tiny_gltf(mesh));
}

TEST_F(MustRender, Mirrored) {
  rendered(tiny_gltf({}, [](json& root) { root["nodes"][0]["scale"] = {-1, 1, 1}; }));
  TinyMesh mesh;
  for (std::size_t i = 0; i < mesh.uvs.size(); i += 2) mesh.uvs[i] = 1 - mesh.uvs[i];  // the texture mirrored
  rendered(tiny_gltf(mesh));
}

TEST_F(MustRender, TextureCoordinatesFarOutside) {
  TinyMesh mesh;
  for (float& uv : mesh.uvs) uv = uv * 100 - 37;
  rendered(tiny_gltf(mesh));
}

TEST_F(MustRender, WithoutSkin) {
  const Result result = rendered(tiny_gltf({}, [](json& root) {
    root["materials"] = {{{"name", "cloth"}}, {{"name", "steel"}}};
    json& primitives = root["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[1]["material"] = 1;
  }));
  EXPECT_NE(result.err.find("warning"), std::string::npos);
}

TEST_F(MustRender, TinyAndHuge) {
  EXPECT_NE(rendered(tiny_gltf(), {"--unit-scale", "0.01"}).err.find("--unit-scale"), std::string::npos);
  EXPECT_NE(rendered(tiny_gltf(), {"--unit-scale", "100"}).err.find("--unit-scale"), std::string::npos);
}

TEST_F(MustRender, EveryTechniqueAndToneMap) {
  for (const char* technique : {"texture-space", "lambert"})
    rendered(tiny_gltf(), {"--technique", technique});
  for (const char* tone_map : {"neutral", "agx", "filmic", "srgb", "linear"})
    rendered(tiny_gltf(), {"--tone-map", tone_map});
}

TEST_F(MustRender, EveryShow) {
  for (const char* show :
       {"irradiance", "stretch", "texel-density", "blur:0", "blur:5", "shadow:0", "shadow:1"}) {
    SCOPED_TRACE(show);
    // All maps: those that the size of the picture does not need are not made otherwise.
    rendered(tiny_gltf(), {"--show", show, "--optimise", "none"});
  }
}

TEST_F(MustRender, SharedHeads) {
  int found = 0;
  for (const char* name :
       {"gltf-valid/head-variants/head-no-uv.glb", "gltf-valid/head-variants/head-no-normals.glb",
        "gltf-valid/head-variants/head-instanced-mirrored-deep.glb",
        "makehuman/crowd/mh-crowd-african-man-old-lod2.glb"}) {
    const fs::path path = asset_cache() / name;
    if (!fs::exists(path)) continue;
    SCOPED_TRACE(name);
    ++found;
    fs::remove(picture());
    expect_rendered(render({path.string()}));
  }
  if (found == 0) GTEST_SKIP() << "set DERMIS_ASSET_CACHE to the folder of the shared assets";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0, end = 0; (end = text.find('\n', from)) != std::string::npos; from = end + 1)
    lines.push_back(text.substr(from, end - from));
  return lines;
}

// From one warning to three: two lines at most, and all of them with --verbose.
TEST_F(MustRender, WarningsBeyondTheFirstAreCountedUnlessAskedFor) {
  const auto of_later_gltf = [](json& root) { root["asset"]["version"] = "2.1"; };
  TinyMesh without_uvs;
  without_uvs.uvs.clear();
  const std::string one = tiny_gltf({}, of_later_gltf), two = tiny_gltf(without_uvs, of_later_gltf);
  // A plan is printed without a device, after the scene has been read.
  const auto said = [&](const std::string& gltf, const Arguments& more) {
    Arguments arguments{"plan", file("head.gltf", gltf)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return lines_of(result.err);
  };

  EXPECT_EQ(said(tiny_gltf(), {}), std::vector<std::string>{});
  const std::vector<std::string> first = said(one, {}), both = said(two, {});
  ASSERT_EQ(first.size(), 1u);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0], first[0]);
  EXPECT_TRUE(both[1].starts_with("dermis: warning: ")) << both[1];

  EXPECT_EQ(said(two, {"--unit-scale", "0.01"}),
            (std::vector<std::string>{first[0], "dermis: 2 more warnings or notes; --verbose shows them"}));
  const std::vector<std::string> all = said(two, {"--unit-scale", "0.01", "--verbose"});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0], first[0]);
  for (const std::string& line : all) EXPECT_TRUE(line.starts_with("dermis: warning: ")) << line;
}

// The files of the shared assets that warn most. What is left to say stands behind --verbose.
TEST_F(MustRender, AFileThatLoadsSaysTwoLinesAtMost) {
  int found = 0;
  for (const char* name :
       {"gltf-valid/head-variants/head-no-uv.glb", "gltf-valid/tinygltf/Extensions-issue97/test.gltf",
        "gltf-valid/tinygltf/box01.glb", "gltf-valid/tinygltf/Cube/Cube.gltf"}) {
    const fs::path path = asset_cache() / name;
    if (!fs::exists(path)) continue;
    SCOPED_TRACE(name);
    ++found;
    fs::remove(picture());
    const Result result = render({path.string()});
    expect_rendered(result);
    EXPECT_LE(std::count(result.err.begin(), result.err.end(), '\n'), 2) << result.err;
  }
  if (found == 0) GTEST_SKIP() << "set DERMIS_ASSET_CACHE to the folder of the shared assets";
}

}  // namespace
}  // namespace dermis::tests
