// SPDX-License-Identifier: MIT
// Scenes of real files, taken apart into arrays and put together again, are the same scenes.
#include "head/scene/arrays/from_arrays.h"
#include "support.h"
#include "support/built_in.h"
#include "support/written_out.h"

namespace dermis::scene::test {
namespace {

// A direction that was made unit in double precision is rounded to float: its length is off by up to 1e-7.
// Made unit again, on the way through the arrays, components move by up to a unit in the last place.
constexpr float rounding = 2.5e-7f;

/// Loads a file with every copy of a mesh written out, as arrays have them.
AssetData load(const fs::path& file) {
  AssetData scene = load_gltf(file);
  std::vector<Primitive> primitives = written_out(scene);
  scene.primitives = std::move(primitives);
  return scene;
}

/// Takes a scene apart and puts it together, with its tangents or, without, with those that are made.
void expect_round_trip(const AssetData& scene, ArraysOf::Tangents tangents) {
  const ArraysOf arrays(scene, tangents);
  const AssetData made = scene_from_arrays(arrays.given);
  EXPECT_EQ(made.name, scene.name);
  expect_same(made, scene, rounding);
}

/// A glTF file of the same arrays gives the same scene, directions too. Pictures are left out: they take long
/// to write, and gltf_test.cpp has them.
void expect_as_gltf(const AssetData& scene) {
  ArraysOf arrays(scene, ArraysOf::Tangents::all);
  const std::vector<std::uint8_t> pixel(4, 200);
  for (AssetImage& image : arrays.given.images) {
    image.width = image.height = 1;
    image.pixels = pixel;
  }
  for (AssetMesh& mesh : arrays.given.meshes) mesh.node = -1;  // a node for each mesh, as the file has
  expect_same(scene_from_arrays(arrays.given), gltf_of(arrays.given).load());
}

TEST(ArraysRoundTrip, TheBuiltInHead) {
  const Warnings quiet;
  const AssetData& head = tests::built_in_head();
  expect_round_trip(head, ArraysOf::Tangents::none);
  expect_round_trip(head, ArraysOf::Tangents::all);
  expect_as_gltf(head);
}

TEST(ArraysRoundTrip, TheScan) {
  if (const std::string missing = tests::missing_scan({}); !missing.empty()) GTEST_SKIP() << missing;
  const Warnings quiet;
  const AssetData scan = load(tests::scan_manifest());
  expect_round_trip(scan, ArraysOf::Tangents::none);
  expect_round_trip(scan, ArraysOf::Tangents::all);
  expect_as_gltf(scan);
}

TEST(ArraysRoundTrip, FilesOfOthers) {
  DERMIS_NEED_ASSETS(root);
  const Warnings quiet;
  for (const char* name :
       {"gltf-valid/assimp/BoxTextured-glTF-Embedded/BoxTextured.gltf",
        "gltf-valid/gltf-asset-generator/Mesh_PrimitiveVertexColor/Mesh_PrimitiveVertexColor_04.gltf",
        "gltf-valid/head-variants/head-draco.glb", "gltf-valid/head-variants/head-nonindexed.glb",
        "gltf-valid/head-variants/head-no-uv.glb",
        "gltf-valid/head-variants/head-lights-camera-specular-ior.glb",
        "gltf-valid/head-variants/head-instanced-mirrored-deep.glb", "gltf-valid/tinygltf/Cube/Cube.gltf",
        "makehuman/crowd/mh-crowd-african-man-old-lod0.glb"}) {
    SCOPED_TRACE(name);
    const AssetData scene = load(*root / name);
    expect_round_trip(scene, ArraysOf::Tangents::all);
    // Tangents of the file, or of a mesh before its nodes bend it, are others than those made here.
    const std::string_view file = name;
    if (!file.ends_with("Cube.gltf") && !file.ends_with("deep.glb"))
      expect_round_trip(scene, ArraysOf::Tangents::none);
    expect_as_gltf(scene);
  }
}

}  // namespace
}  // namespace dermis::scene::test
