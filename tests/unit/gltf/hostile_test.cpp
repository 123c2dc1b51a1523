// SPDX-License-Identifier: MIT
// Files that want to hurt: each ends in one line that names the place, quickly and without taking memory.
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "support.h"

namespace dermis::scene::test {

namespace {

/// The error of a triangle after `bend` has had its way with it.
template <class Bend>
std::string bent(const Bend& bend) {
  Builder b;
  b.triangle();
  bend(b);
  const Warnings quiet;
  return b.error();
}

/// Loads bytes that may be anything: InputError or a scene, nothing else.
void try_bytes(const TempFolder& folder, const std::string& bytes) {
  write_text(folder.path() / "mutant.glb", bytes);
  const Warnings quiet;
  error_of(folder.path() / "mutant.glb");
}

/// `rounds` copies with a few bytes changed each; the seed is fixed, so a crash can be repeated.
void flip_bytes(const std::string& original, int rounds, std::size_t first_byte = 0) {
  const TempFolder folder;
  std::mt19937 random(20240229);
  for (int round = 0; round < rounds; ++round) {
    std::string mutant = original;
    for (unsigned flips = 1 + random() % 4; flips > 0; --flips)
      mutant[first_byte + random() % (mutant.size() - first_byte)] = static_cast<char>(random());
    ASSERT_NO_FATAL_FAILURE(try_bytes(folder, mutant)) << "round " << round;
  }
}

/// Round trips through JSON: numbers become others, members vanish.
void bend_values(const Json& original, const std::string& bin, int rounds) {
  const TempFolder folder;
  std::mt19937 random(7);
  const Json flat = original.flatten();
  const Json wild = Json::parse(
      R"([0, -1, 1, 2, 3, 255, 65535, 4294967295, 4294967296, 281474976710656, 1e300,
          0.5, null, true, "x", [], {}, [1], {"a": 1}])");

  for (int round = 0; round < rounds; ++round) {
    Json mutant = original;
    for (unsigned changes = 1 + random() % 2; changes > 0; --changes) {
      auto where = flat.begin();
      std::advance(where, static_cast<std::ptrdiff_t>(random() % flat.size()));
      // An earlier change may have removed what this pointer goes through.
      if (mutant.contains(Json::json_pointer(where.key())))
        mutant[Json::json_pointer(where.key())] = wild[random() % wild.size()];
    }

    Builder b;
    b.json = mutant;
    b.bytes = bin;
    ASSERT_NO_FATAL_FAILURE(try_bytes(folder, b.glb())) << "round " << round;
  }
}

/// The Draco head taken apart, so that single numbers of it can be changed.
Builder draco_head(const fs::path& root) {
  const std::string file = read_text(root / "gltf-valid" / "head-variants" / "head-draco.glb");
  std::uint32_t json_length = 0;
  std::memcpy(&json_length, file.data() + 12, 4);
  Builder b;
  b.json = Json::parse(file.substr(20, json_length));
  b.bytes = file.substr(20 + json_length + 8);
  return b;
}

Json& draco_extension(Builder& b) {
  return b.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
}

}  // namespace

TEST(GltfHostile, ScanCutOffAtTwentyPlaces) {
  DERMIS_NEED_ASSETS(root);
  const std::string scan = read_text(*root / "lee-perry-smith" / "LeePerrySmith.glb");
  const TempFolder folder;
  for (std::size_t i = 0; i < 20; ++i) {
    write_text(folder.path() / "cut.glb", scan.substr(0, scan.size() * i / 20));
    EXPECT_NE(error_of(folder.path() / "cut.glb"), "") << i;
  }
  // A header that agrees with the cut: the chunk reaches too far.
  std::string cut = scan.substr(0, 300000);
  const std::uint32_t length = 300000;
  std::memcpy(cut.data() + 8, &length, sizeof length);
  write_text(folder.path() / "cut.glb", cut);
  EXPECT_ERROR(error_of(folder.path() / "cut.glb"), "reaches past the end");
}

TEST(GltfHostile, NotFiles) {
  const TempFolder folder;
  EXPECT_ERROR(error_of(folder.path() / "none.glb"), "no such file");
  EXPECT_ERROR(error_of(folder.path()), "is a directory");
  write_text(folder.path() / "empty.gltf", "");
  EXPECT_ERROR(error_of(folder.path() / "empty.gltf"), "is empty");
  write_text(folder.path() / "text.gltf", "solid cube");
  EXPECT_ERROR(error_of(folder.path() / "text.gltf"), "is not glTF");
  write_text(folder.path() / "deep.gltf",
             "{\"a\":" + std::string(100000, '[') + std::string(100000, ']') + "}");
  EXPECT_ERROR(error_of(folder.path() / "deep.gltf"), "nested deeper");
  write_text(folder.path() / "open.gltf", "{\"a\":" + std::string(100000, '{'));
  EXPECT_NE(error_of(folder.path() / "open.gltf"), "");
  write_text(folder.path() / "utf8.gltf", "{\"asset\": {\"version\": \"\xff\xfe\"}}");
  EXPECT_ERROR(error_of(folder.path() / "utf8.gltf"), "not valid JSON");
}

TEST(GltfHostile, NumbersThatAreNone) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    Builder b;
    b.mesh({{"POSITION", b.accessor({0, 0, 0, bad, 0, 0, 0, 1, 0}, "VEC3")}});
    EXPECT_ERROR(b.error(), "POSITION of vertex 1 is not finite");

    Builder normal;  // can be made anew
    normal.triangle();
    normal.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        normal.accessor({0, 0, bad, 0, 0, 0, 0, 0, 5}, "VEC3");
    const AssetData made = normal.load();
    for (const Vertex& v : made.primitives[0].vertices) EXPECT_EQ(v.normal, glm::vec3(0, 0, 1));
  }

  EXPECT_ERROR(bent([](Builder& b) {
                 b.json["nodes"][0]["translation"] = {1e30, 0, 0};
               }),
               "more than 1000000 m from the origin");
  EXPECT_ERROR(bent([](Builder& b) { b.json["nodes"][0]["translation"] = {1e300, 0, 0}; }), "out of range");
  EXPECT_ERROR(bent([](Builder& b) { b.json["nodes"][0]["matrix"] = std::vector<double>(16, 1); }),
               "last row");
}

TEST(GltfHostile, RangesAndReferences) {
  EXPECT_ERROR(bent([](Builder& b) {
                 b.json["meshes"][0]["primitives"][0]["indices"] = b.accessor({0, 1, 3}, "SCALAR", 5123);
               }),
               "index 2 is 3, there are 3 vertices");

  EXPECT_ERROR(bent([](Builder& b) { b.json["accessors"][0]["count"] = 4; }),
               "reach past the end of its bufferView");
  EXPECT_ERROR(bent([](Builder& b) { b.json["accessors"][0]["byteOffset"] = 4; }),
               "reach past the end of its bufferView");
  EXPECT_ERROR(bent([](Builder& b) { b.json["accessors"][0]["count"] = 1ull << 47; }),
               "reach past the end of its bufferView");
  EXPECT_ERROR(bent([](Builder& b) { b.json["accessors"][0]["count"] = 1ull << 63; }), "must be 0 to");
  EXPECT_ERROR(bent([](Builder& b) { b.json["accessors"][0]["count"] = 0; }), "no triangles to draw");
  EXPECT_ERROR(bent([](Builder& b) { b.json["accessors"][0]["count"] = -3; }), "must be 0 to");
  EXPECT_ERROR(bent([](Builder& b) { b.json["accessors"][0]["count"] = 2.5; }), "must be an integer");

  EXPECT_ERROR(bent([](Builder& b) { b.json["bufferViews"][0]["byteLength"] = 1000; }),
               "reach past the end of its buffer");
  EXPECT_ERROR(bent([](Builder& b) { b.json["bufferViews"][0]["byteOffset"] = (1ull << 48) - 1; }),
               "reach past the end of its buffer");
  EXPECT_ERROR(bent([](Builder& b) {
                 b.json["buffers"][0]["byteLength"] = 1000;
                 b.json["bufferViews"][0]["byteOffset"] = 40;
               }),
               "cut off: bytes 40 to 76 are used, there are 60");

  EXPECT_ERROR(bent([](Builder& b) { b.json["nodes"][0]["mesh"] = 1; }), "there is no mesh 1");
  EXPECT_ERROR(bent([](Builder& b) { b.json["nodes"][0]["mesh"] = "0"; }), "must be an integer, is string");
  EXPECT_ERROR(bent([](Builder& b) { b.json["meshes"][0]["primitives"] = Json::array(); }),
               "no triangles to draw");
  EXPECT_ERROR(bent([](Builder& b) { b.json["meshes"][0]["primitives"][0]["mode"] = 7; }), "must be 0 to 6");

  EXPECT_ERROR(bent([](Builder& b) { b.json["asset"]["version"] = "1.0"; }), "glTF 1.0 is not supported");
  EXPECT_ERROR(bent([](Builder& b) { b.json["extensionsRequired"] = {"EXT_of_tomorrow"}; }),
               "requires the extension EXT_of_tomorrow");
}

TEST(GltfHostile, NothingToDraw) {
  EXPECT_ERROR(bent([](Builder& b) { b.json["scenes"][0].erase("nodes"); }), "no triangles to draw");
  EXPECT_ERROR(bent([](Builder& b) { b.json["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }),
               "no triangles to draw");
  EXPECT_ERROR(bent([](Builder& b) {
                 b.json["meshes"][0]["primitives"][0]["indices"] = b.accessor({0, 1}, "SCALAR", 5123);
               }),
               "no triangles to draw");
  EXPECT_EQ(bent([](Builder& b) {
              b.json["meshes"][0]["primitives"][0]["indices"] = b.accessor({0, 0, 1}, "SCALAR", 5123);
            }),
            "");  // degenerate: drawn as nothing
}

TEST(GltfHostile, SmallFilesThatClaimMuch) {
  // Zeros cost the file nothing.
  EXPECT_ERROR(bent([](Builder& b) {
                 b.json["accessors"][0] = {{"componentType", 5126}, {"count", 1u << 30}, {"type", "VEC3"}};
               }),
               "without a bufferView");
  EXPECT_ERROR(bent([](Builder& b) {
                 b.json["meshes"][0]["primitives"][0]["indices"] = b.accessor({0}, "SCALAR", 5125);
                 b.json["accessors"][2].erase("bufferView");
               }),
               "no bufferView");

  LoadOptions few;
  few.max_triangles = 5;
  Builder many;
  many.triangle();
  for (int i = 0; i < 5; ++i) {
    many.json["nodes"].push_back({{"mesh", 0}});
    many.json["scenes"][0]["nodes"].push_back(i + 1);
  }
  EXPECT_ERROR(many.error(few), "more than 5 triangles");

  const std::string meshopt = bent([](Builder& b) {
    b.json["buffers"].push_back(
        {{"byteLength", 1ull << 40}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
    b.json["bufferViews"][0] = {{"buffer", 1},
                                {"byteLength", 12ull << 30},
                                {"extensions",
                                 {{"EXT_meshopt_compression",
                                   {{"buffer", 0},
                                    {"byteLength", 36},
                                    {"byteStride", 12},
                                    {"count", 1u << 30},
                                    {"mode", "ATTRIBUTES"}}}}}};
  });
  EXPECT_ERROR(meshopt, "36 compressed bytes cannot hold");

  const std::string draco = bent([](Builder& b) {
    // Header of an edgebreaker mesh, bitstream 2.2, that claims 2^28 vertices and faces.
    const std::string header("DRACO\x02\x02\x01\x01\x00\x00\x00\x80\x80\x80\x80\x01\x80\x80\x80\x80\x01", 22);
    b.json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", b.bytes.size()}, {"byteLength", header.size()}});
    b.bytes += header + std::string(2, '\0');
    b.json["buffers"][0]["byteLength"] = b.bytes.size();
    Json& primitive = b.json["meshes"][0]["primitives"][0];
    primitive["indices"] = b.accessor({0, 1, 2}, "SCALAR", 5123);
    primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 2},
                                                             {"attributes", {{"POSITION", 0}}}};
  });
  EXPECT_ERROR(draco, "Draco data holds 268435456 triangles");
}

TEST(GltfHostile, MessagesStayOneLine) {
  const std::string nasty = "a\nb\r\x1b[2J" + std::string(5000, 'x');
  for (const std::string& error : {bent([&](Builder& b) { b.json["extensionsRequired"] = {nasty}; }),
                                   bent([&](Builder& b) { b.json["buffers"][0]["uri"] = nasty; })}) {
    ASSERT_FALSE(error.empty());
    EXPECT_LE(error.size(), 2000u);
    for (const char c : error) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
  }

  Builder b;
  b.triangle();
  b.json["meshes"][0]["primitives"][0]["attributes"][nasty] = 99;
  b.json["images"] = {{{"uri", nasty}}};
  b.json["textures"] = {{{"source", 0}}};
  b.json["materials"] = {{{"name", "skin"}, {"normalTexture", {{"index", 0}}}},
                         {{"name", "lash"}, {"normalTexture", {{"index", 7}, {nasty, 1}}}}};
  for (const int material : {0, 1}) {
    b.json["meshes"][0]["primitives"][0]["material"] = material;
    const tests::LogLines said;
    EXPECT_EQ(b.error(), "");
    EXPECT_GE(said.all.size(), 2u);
    for (const std::string& line : said.all)
      for (const char c : line) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
  }
}

TEST(GltfHostile, DracoDataThatDoesNotFit) {
  DERMIS_NEED_ASSETS(root);
  const Builder original = draco_head(*root);

  const auto error = [&](const auto& bend) {
    Builder b = original;
    bend(b);
    return b.error();
  };
  const Json& primitive = original.json["meshes"][0]["primitives"][0];

  EXPECT_EQ(error([](Builder&) {}), "");
  EXPECT_ERROR(error([&](Builder& b) { b.json["accessors"][primitive["indices"].get<int>()]["count"] = 3; }),
               "triangles");
  EXPECT_ERROR(error([&](Builder& b) {
                 for (const auto& [name, a] : primitive["attributes"].items())
                   b.json["accessors"][a.template get<int>()]["count"] = 7;
               }),
               "vertices");
  EXPECT_ERROR(error([](Builder& b) { draco_extension(b)["attributes"]["POSITION"] = 99; }),
               "no attribute 99");
}

TEST(GltfHostile, DracoMetadataIsSteppedOver) {
  DERMIS_NEED_ASSETS(root);
  Builder b = draco_head(*root);
  Json view = b.json["bufferViews"][draco_extension(b)["bufferView"].get<int>()];
  std::string data = b.bytes.substr(view.value("byteOffset", 0u), view["byteLength"]);

  data[10] = static_cast<char>(0x80);  // flags: metadata follow the header's 11 bytes
  // One attribute's {id 0: no entries, no children}; the mesh's: one entry "k" = 2 bytes, one child "c" that
  // is empty.
  data.insert(11, std::string("\x01\x00\x00\x00\x01\x01k\x02xy\x01\x01"
                              "c\x00\x00",
                              15));

  // Append the data to the buffer and let the extension read them there.
  view["byteOffset"] = b.bytes.size();
  view["byteLength"] = data.size();
  b.bytes += data + std::string((4 - data.size() % 4) % 4, '\0');
  b.json["buffers"][0]["byteLength"] = b.bytes.size();
  b.json["bufferViews"].push_back(view);
  draco_extension(b)["bufferView"] = b.json["bufferViews"].size() - 1;
  EXPECT_EQ(b.error(), "");

  const Json& indices = b.json["meshes"][0]["primitives"][0]["indices"];
  b.json["accessors"][indices.get<int>()]["count"] = 3;  // still found behind the metadata
  EXPECT_ERROR(b.error(), "the accessor of the indices says 1");
}

TEST(GltfHostile, FlippedBytes) {
  Builder b;
  b.triangle();
  flip_bytes(b.glb(), 400);
}

TEST(GltfHostile, FlippedBytesOfRealFiles) {
  DERMIS_NEED_ASSETS(root);
  const fs::path variants = *root / "gltf-valid" / "head-variants";
  for (const char* name : {"head-draco.glb", "head-sparse-over-base.glb"})
    flip_bytes(read_text(variants / name), 60);
  flip_bytes(read_text(*root / "gltf-valid" / "meshoptimizer" / "fuzz-seed.glb"), 200);
}

TEST(GltfHostile, BentValues) {
  Builder b;
  b.triangle();

  const int joints = b.accessor(std::vector<float>(12, 0), "VEC4", 5121);
  const int weights = b.accessor(std::vector<float>(12, 0.25f), "VEC4");
  b.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = joints;
  b.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = weights;
  b.json["meshes"][0]["primitives"][0]["indices"] = b.accessor({0, 1, 2}, "SCALAR", 5123);
  b.json["meshes"][0]["primitives"][0]["targets"] = Json::array({{{"POSITION", 0}}});
  b.json["meshes"][0]["weights"] = {0.5};

  b.json["nodes"][0]["skin"] = 0;
  b.json["nodes"].push_back({{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
  b.json["skins"] = Json::array({{{"joints", {1}}}});
  b.json["accessors"][0]["sparse"] = {{"count", 1},
                                      {"indices", {{"bufferView", 4}, {"componentType", 5123}}},
                                      {"values", {{"bufferView", 0}}}};
  b.json["cameras"] = Json::parse(R"([{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.2}}])");

  ASSERT_EQ(b.error(), "");
  bend_values(b.json, b.bytes, 1500);
}

}  // namespace dermis::scene::test
