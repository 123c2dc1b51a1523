// SPDX-License-Identifier: MIT
// Files that cannot be used: each ends with exit status 1, one line that says what is wrong where, and no
// picture.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "cli/program.h"
#include "cli/tiny_gltf.h"
#include "support/assets.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class RefusedFiles : public Program {
 protected:
  void refuse(const std::string& gltf, const std::string& says) const {
    expect_refused(render({file("bad.gltf", gltf)}), says);
  }
};

TEST_F(RefusedFiles, TheWholeOneRenders) {
  EXPECT_TRUE(expect_rendered(render({file("good.gltf", tiny_gltf())})));
}

TEST_F(RefusedFiles, WhatIsNoFile) {
  expect_refused(render({(folder() / "missing.glb").string()}), "missing.glb: no such file");
  expect_refused(render({folder().string()}), "is a directory");
  expect_refused(render({file("empty.glb", "")}), "empty.glb: is empty");
  expect_refused(render({"/dev/null"}), "is not a regular file");
  expect_refused(render({file("noise.gltf", "\x01\x02 this is not JSON")}), "noise.gltf");
  expect_refused(render({file("noise.glb", std::string(1000, '\xff'))}), "noise.glb");
  expect_refused(render({file("picture.jpg", "no scene at all")}), "picture.jpg");
  expect_refused(render({(folder() / "line\nbreak.glb").string()}), "no such file");
}

TEST_F(RefusedFiles, IndicesOutOfRange) {
  TinyMesh mesh;
  mesh.indices[5] = 81;  // there are 0 to 80
  refuse(tiny_gltf(mesh), "81");
  mesh.indices[5] = 0xFFFFFFFF;
  refuse(tiny_gltf(mesh), "bad.gltf");
}

TEST_F(RefusedFiles, PositionsThatAreNoNumbers) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    TinyMesh mesh;
    mesh.positions[30] = bad;
    refuse(tiny_gltf(mesh,
                     [](json& root) {
                       root["accessors"][0]["min"] = {-1, -1, -1}, root["accessors"][0]["max"] = {1, 1, 1};
                     }),
           "POSITION");
  }
}

TEST_F(RefusedFiles, NothingToDraw) {
  TinyMesh none;
  none.indices.clear(), none.positions.clear(), none.normals.clear(), none.uvs.clear();
  refuse(tiny_gltf(none), "bad.gltf");
  // lines
  refuse(tiny_gltf({}, [](json& root) { root["meshes"][0]["primitives"][0]["mode"] = 1; }), "triangle");
  refuse(tiny_gltf({}, [](json& root) { root["nodes"][0].erase("mesh"); }), "bad.gltf");
  TinyMesh flat;
  for (float& p : flat.positions) p = 0.25f;  // every triangle is a point
  refuse(tiny_gltf(flat), "bad.gltf");
}

TEST_F(RefusedFiles, RequiredExtensions) {
  refuse(tiny_gltf(
             {}, [](json& root) { root["extensionsUsed"] = root["extensionsRequired"] = {"ACME_surprise"}; }),
         "ACME_surprise");
  refuse(tiny_gltf({},
                   [](json& root) {
                     root["extensionsUsed"] = root["extensionsRequired"] = {"KHR_texture_basisu"};
                   }),
         "KHR_texture_basisu");
}

TEST_F(RefusedFiles, SizesThatLie) {
  refuse(tiny_gltf({}, [](json& root) { root["accessors"][0]["count"] = 4000000000u; }), "bad.gltf");
  refuse(tiny_gltf({}, [](json& root) { root["accessors"][0]["count"] = -1; }), "bad.gltf");
  refuse(tiny_gltf({}, [](json& root) { root["bufferViews"][0]["byteLength"] = 1ull << 62; }), "bad.gltf");
  refuse(tiny_gltf({}, [](json& root) { root["buffers"][0]["byteLength"] = 1ull << 62; }), "bad.gltf");
  refuse(tiny_gltf({}, [](json& root) { root["bufferViews"][3]["byteOffset"] = 1ull << 63; }), "bad.gltf");
  refuse(tiny_gltf({}, [](json& root) { root["buffers"][0]["uri"] = "missing.bin"; }), "missing.bin");
}

TEST_F(RefusedFiles, CamerasThatSeeNothingAreMendedOrLeftOut) {
  const auto with = [](json perspective) {
    return tiny_gltf({}, [&](json& root) {
      root["cameras"] = {{{"type", "perspective"}, {"perspective", perspective}}};
      root["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 1}}});
      root["scenes"][0]["nodes"] = {0, 1};
    });
  };
  EXPECT_TRUE(expect_rendered(render({file("good.gltf", with({{"yfov", 0.5}, {"znear", 0.01}}))})));
  fs::remove(picture());
  for (const json& faulty :
       {json{{"yfov", 0.5}, {"znear", -1}}, json{{"yfov", 4}, {"znear", 0.01}}, json{{"znear", 0.01}}}) {
    const Result result = render({file("faulty.gltf", with(faulty))});
    EXPECT_TRUE(expect_rendered(result));
    EXPECT_NE(result.err.find("cameras[0]"), std::string::npos) << result.err;
    fs::remove(picture());
  }
}

// Each light needs a layer of the shadow maps, more than any device has.
TEST_F(RefusedFiles, MoreLightsThanADeviceTakes) {
  refuse(tiny_gltf({},
                   [](json& root) {
                     root["extensionsUsed"] = {"KHR_lights_punctual"};
                     root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}}};
                     for (int i = 1; i <= 20000; ++i) {
                       root["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
                       root["scenes"][0]["nodes"].push_back(i);
                     }
                   }),
         "light");
}

TEST_F(RefusedFiles, MapsThatAreNoPictures) {
  const auto with = [](const std::string& bytes) {
    return tiny_gltf({}, [&](json& root) {
      root["images"] = {{{"uri", data_uri("image/png", bytes)}}};
      root["textures"] = {{{"source", 0}}};
      root["materials"][0]["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 0}}}};
    });
  };
  refuse(with("no picture"), "bad.gltf");
  refuse(with(""), "bad.gltf");
  // A header that promises 100,000 x 100,000 pixels, more than any device takes.
  constexpr unsigned char giant[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d,
                                     0x49, 0x48, 0x44, 0x52, 0x00, 0x01, 0x86, 0xa0, 0x00, 0x01, 0x86, 0xa0,
                                     0x08, 0x06, 0x00, 0x00, 0x00, 0xa8, 0x52, 0x0b, 0xc8, 0x00, 0x00, 0x00,
                                     0x0c, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x60, 0xa0, 0x3d, 0x00,
                                     0x00, 0x00, 0x64, 0x00, 0x01, 0xb8, 0x99, 0xef, 0x99, 0x00, 0x00, 0x00,
                                     0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  refuse(with(std::string(std::begin(giant), std::end(giant))), "100000");
}

class RefusedScan : public Program {
 protected:
  static fs::path scan_folder() { return scan_manifest().parent_path(); }

  void SetUp() override {
    if (const std::string missing = missing_scan(); !missing.empty()) GTEST_SKIP() << missing;
  }
};

// Cut at twenty places each: the file itself, the buffer beneath the manifest, and the manifest.
TEST_F(RefusedScan, Truncated) {
  for (const char* name : {"LeePerrySmith.glb", "lee-perry-smith.gltf"}) {
    const std::string whole = read_text(scan_folder() / name);
    ASSERT_GT(whole.size(), 100u);
    for (std::size_t i = 0; i < 20; ++i) {
      const std::size_t bytes = whole.size() * i / 20;
      SCOPED_TRACE(fmt::format("{} cut to {} of {} bytes", name, bytes, whole.size()));
      expect_refused(render({file(name, whole.substr(0, bytes))}), name);
    }
  }
}

TEST_F(RefusedScan, ItsFilesTruncated) {
  for (const auto& entry : fs::directory_iterator(scan_folder()))
    fs::create_symlink(entry.path(), folder() / entry.path().filename());
  const std::string manifest = (folder() / "lee-perry-smith.gltf").string();
  for (const char* name : {"LeePerrySmith.glb", "Map-COL.jpg"}) {
    const std::string whole = read_text(scan_folder() / name);
    for (std::size_t i = 0; i < 5; ++i) {
      SCOPED_TRACE(fmt::format("{} cut to {} of 5", name, i));
      fs::remove(folder() / name);
      file(name, whole.substr(0, whole.size() * i / 5));
      expect_refused(render({manifest}), "");
    }
    fs::remove(folder() / name);
    expect_refused(render({manifest}), name);
    fs::create_symlink(scan_folder() / name, folder() / name);
  }
  EXPECT_TRUE(expect_rendered(render({manifest})));
}

class RefusedProfiles : public Program {
 protected:
  Result with_profile(const std::string& text) const {
    return render({file("head.gltf", tiny_gltf()), "--profile", file("profile.json", text)});
  }
};

TEST_F(RefusedProfiles, EachSaysWhatIsWrong) {
  expect_refused(with_profile(R"({"name": "p", "variances_mm2": [-0.1], "weights": [[1, 1, 1]]})"),
                 "variance");
  expect_refused(with_profile(R"({"name": "p", "variances_mm2": [0.1, 0.5], "weights": [[1, 1, 1]]})"),
                 "weights");
  expect_refused(with_profile(R"({"name": "p", "variances_mm2": [0.1], "weights": [[0.5, 1, 1]]})"), "sum");
  expect_refused(with_profile(R"({"name": "p", "variances_mm2": [], "weights": []})"), "profile.json");
  expect_refused(with_profile(R"({"name": "p", "variances_mm2": [1e999], "weights": [[1, 1, 1]]})"),
                 "profile.json");
  expect_refused(with_profile("{"), "profile.json");
  expect_refused(with_profile(""), "profile.json");
  expect_refused(render({file("head.gltf", tiny_gltf()), "--profile", "no-such-profile"}), "skin");
  expect_refused(render({file("head.gltf", tiny_gltf()), "--profile", folder().string()}), folder().string());
}

}  // namespace
}  // namespace dermis::tests
