// SPDX-License-Identifier: MIT
// Arrays give the scene that a glTF file with the same content gives, to the bit and with the same warnings.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "head/scene/arrays/from_arrays.h"
#include "support.h"

namespace dermis::scene::test {
namespace {

/// A bumpy sheet 0.2 m high of 6 x 6 quads, whose right half has mirrored texture coordinates.
OwnedMesh sheet(std::uint32_t seed) {
  constexpr std::uint32_t side = 7;
  std::mt19937 random(seed);
  const auto number = [&] { return std::uniform_real_distribution<float>(-1, 1)(random); };
  OwnedMesh mesh;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const float u = static_cast<float>(x) / (side - 1), v = static_cast<float>(y) / (side - 1);
      mesh.positions_m.push_back({0.2f * u, 0.2f * v, 0.01f * number()});
      mesh.normals.push_back({number(), number(), 3 * (2 + number())});
      mesh.tangents.push_back({2 + number(), number(), number(), number() < 0 ? -1.0f : 1.0f});
      mesh.colours.push_back({1 + number(), 1 + number(), 1 + number(), 0.5f + number()});
      mesh.uv0.push_back({std::abs(u - 0.5f), 1 - v + 0.01f * number()});
      mesh.uv1.push_back({3 * number(), 3 * number()});
    }
  for (std::uint32_t y = 0; y + 1 < side; ++y)
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      const std::uint32_t a = y * side + x, b = a + side;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  return mesh;
}

std::vector<std::uint8_t> noise(std::size_t bytes, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> values(bytes);
  for (std::uint8_t& value : values) value = static_cast<std::uint8_t>(random());
  return values;
}

/// One mesh of glTF's default material.
AssetArrays one_mesh(const OwnedMesh& mesh) {
  AssetArrays given;
  given.name = "given";
  given.meshes.resize(1);
  given.meshes[0].name = "sheet";
  mesh.lend(given.meshes[0]);
  return given;
}

/// What was said, with the name of the asset in place of the file's.
std::string said(const Warnings& warnings, const std::string& file, const std::string& name) {
  std::string text = warnings.all();
  for (std::size_t at = 0; (at = text.find(file, at)) != std::string::npos; at += name.size())
    text.replace(at, file.size(), name);
  return text;
}

/// Expects the same scene and the same lines from arrays and from a file of them; returns the lines.
std::string expect_as_gltf(const AssetArrays& given, const LoadOptions& options = {}) {
  const TempFolder folder;
  const fs::path file = gltf_of(given).write(folder.path());
  AssetData expected;
  std::string lines;
  {
    const Warnings warnings;
    expected = load_gltf(file, options);
    lines = said(warnings, file.string(), given.name);
  }
  const Warnings warnings;
  expect_same(scene_from_arrays(given, options), expected);
  EXPECT_EQ(warnings.all(), lines);
  return lines;
}

TEST(ArraysAsGltf, NothingButPositions) {
  OwnedMesh mesh = sheet(1);
  mesh = {.positions_m = mesh.positions_m,
          .normals = {},
          .tangents = {},
          .colours = {},
          .uv0 = {},
          .uv1 = {},
          .indices = mesh.indices};
  mesh.indices.insert(mesh.indices.end(), {3, 3, 4});  // no area
  expect_as_gltf(one_mesh(mesh));

  // Every three vertices are a triangle.
  mesh.positions_m.resize(48);
  mesh.indices.clear();
  expect_as_gltf(one_mesh(mesh));
}

TEST(ArraysAsGltf, EachSetOfAttributes) {
  for (unsigned set = 0; set < 32; ++set) {
    SCOPED_TRACE(set);
    OwnedMesh mesh = sheet(set + 10);
    if ((set & 1) == 0) mesh.normals.clear();
    if ((set & 2) == 0) mesh.tangents.clear();
    if ((set & 4) == 0) mesh.uv0.clear();
    if ((set & 8) == 0) mesh.uv1.clear();
    if ((set & 16) == 0) mesh.colours.clear();
    expect_as_gltf(one_mesh(mesh));
  }
}

TEST(ArraysAsGltf, NormalsAndTangentsThatAreNone) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const std::array<float, 3>& normal :
       {std::array{0.0f, 0.0f, 0.0f}, {nan, 0.0f, 1.0f}, {0.0f, inf, 0.0f}}) {
    OwnedMesh mesh = sheet(2);
    mesh.normals[5] = normal;
    expect_as_gltf(one_mesh(mesh));
  }
  for (const std::array<float, 4>& tangent :
       {std::array{0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 0.0f, 0.5f}, {nan, 0.0f, 0.0f, 1.0f}}) {
    OwnedMesh mesh = sheet(3);
    mesh.tangents[5] = tangent;
    expect_as_gltf(one_mesh(mesh));
  }
}

TEST(ArraysAsGltf, UnusedVerticesAndUnits) {
  OwnedMesh mesh = sheet(4);
  mesh.indices.erase(mesh.indices.begin(), mesh.indices.begin() + 30);
  const AssetArrays given = one_mesh(mesh);
  expect_as_gltf(given);
  expect_as_gltf(given, {.unit_scale = 0.37});
  EXPECT_NE(expect_as_gltf(given, {.unit_scale = 10}).find("the skin is 2 m high"), std::string::npos);
}

/// Two materials with all that a material may have, four images of 1 to 4 channels, and meshes that use them.
struct Whole {
  OwnedMesh face = sheet(5), cloth = sheet(6);
  std::vector<std::vector<std::uint8_t>> pixels;
  AssetArrays given;

  Whole() {
    given.name = "whole";
    for (int channels = 1; channels <= 4; ++channels) {
      const int width = 32 + 5 * channels, height = 48;
      pixels.push_back(
          noise(static_cast<std::size_t>(width * height * channels), static_cast<std::uint32_t>(channels)));
      given.images.push_back(
          {.name = "image", .width = width, .height = height, .channels = channels, .pixels = {}});
      given.images.back().name += std::to_string(channels);
    }
    for (std::size_t i = 0; i < 4; ++i) given.images[i].pixels = pixels[i];

    given.meshes.resize(2);
    given.meshes[0].name = "face";
    given.meshes[1].name = "cloth";
    face.lend(given.meshes[0]);
    cloth.lend(given.meshes[1]);
    given.materials = {skin(), surface()};
    given.meshes[0].material = 0;
    given.meshes[1].material = 1;
  }
  Whole(const Whole&) = delete;
  Whole& operator=(const Whole&) = delete;

  static AssetMap map(int image, int uv_set = 0) {
    AssetMap map;
    map.image = image;
    map.uv_set = uv_set;
    map.transform = {{{2, 0}, {0, -0.5f}, {0.25f, 1}}};
    map.wrap_u = AssetWrap::clamp;
    map.wrap_v = AssetWrap::mirror;
    map.nearest = image == 2;
    return map;
  }

  static AssetMaterial skin() {
    AssetMaterial m;
    m.name = "face";
    m.skin = true;
    m.base_colour = {0.9f, 0.8f, 0.7f, 1};
    m.base_colour_map = map(2);
    m.metallic = 0;
    m.normal_map = map(3);
    m.normal_scale = -0.7f;
    AssetSkin& s = m.skin_settings;
    s.profile.emplace();
    s.profile->terms = {{0.05, {0.25, 0.5, 1}}, {0.8, {0.75, 0.5, 0}}};
    s.mix = 0.3f;
    s.specular = {map(0, 1), 3, 1.5f};
    s.roughness = {map(3), 2, 0.5f};
    s.displacement = map(1);
    s.displacement_mm = 2.5f;
    s.displacement_middle = 0.4f;
    s.detail = map(2);
    s.detail_scale = 1.25f;
    s.lobes = {{0.5f, 0.25f}, {2, 0.75f}};
    return m;
  }

  static AssetMaterial surface() {
    AssetMaterial m;
    m.name = "cloth";
    m.roughness = 0.4f;
    m.metallic = 0.25f;
    m.metallic_roughness_map = map(3);
    m.occlusion_map = map(0, 1);
    m.occlusion_strength = 0.6f;
    m.emissive = {0.1f, 0.2f, 0.3f};
    m.emissive_map = map(2);
    m.ior = 1.8f;
    m.specular = 0.7f;
    m.specular_map = map(3);
    m.specular_colour = {0.5f, 2, 1};
    m.specular_colour_map = map(2, 1);
    m.alpha = AssetAlpha::mask;
    m.alpha_cutoff = 0.3f;
    m.double_sided = true;
    m.unlit = true;
    return m;
  }
};

TEST(ArraysAsGltf, EveryMemberOfAMaterial) {
  const Whole whole;
  expect_as_gltf(whole.given);
}

// Defaults are glTF's; the index of refraction is that of skin where a material is.
TEST(ArraysAsGltf, AMaterialThatSaysNothing) {
  const OwnedMesh mesh = sheet(7);
  AssetArrays given = one_mesh(mesh);
  expect_as_gltf(given);
  given.materials.resize(2);
  given.materials[1].name = "Skin of the face";
  given.meshes.push_back(given.meshes[0]);
  given.meshes[0].material = 0;
  given.meshes[1].material = 1;
  expect_as_gltf(given);
  EXPECT_EQ(scene_from_arrays(given).materials[1].ior, 1.4f);

  given.materials[1].name = "face";
  EXPECT_NE(expect_as_gltf(given).find("given: no material is skin"), std::string::npos);
  given.materials[0].skin = true;
  given.materials[0].ior = 0.0f;
  expect_as_gltf(given);
  expect_as_gltf(given, {.skin_material = {"face"}});
}

TEST(ArraysAsGltf, BlendedSkinIsASurface) {
  Whole whole;
  whole.given.materials[0].alpha = AssetAlpha::blend;
  EXPECT_NE(expect_as_gltf(whole.given).find("whole: skin with alphaMode BLEND"), std::string::npos);
}

TEST(ArraysAsGltf, MapsWithoutCoordinatesAreLeftOut) {
  Whole whole;
  whole.given.meshes[1].uv1 = {};
  expect_as_gltf(whole.given);
  whole.given.meshes.push_back(whole.given.meshes[0]);
  whole.given.meshes[0].uv0 = {};
  EXPECT_NE(expect_as_gltf(whole.given).find("no texture coordinates"), std::string::npos);
}

TEST(ArraysAsGltf, TheTextureBudgetHoldsForArrays) {
  const Whole whole;
  for (const double mb : {0.08, 0.05, 0.01})
    EXPECT_NE(expect_as_gltf(whole.given, {.texture_budget_mb = mb}).find("the texture budget is"),
              std::string::npos);
}

TEST(ArraysAsGltf, UnusedMaterialsAndImagesAreDropped) {
  Whole whole;
  whole.given.meshes.erase(whole.given.meshes.begin());
  expect_as_gltf(whole.given);
  const Warnings quiet;
  const AssetData scene = scene_from_arrays(whole.given);
  EXPECT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.images.size(), 3u);
}

// What a file says by its nodes.
TEST(ArraysAsGltf, MeshesOfOneNodeAreOneHead) {
  const OwnedMesh mesh = sheet(8);
  AssetArrays given = one_mesh(mesh);
  given.materials.resize(1);
  given.materials[0].skin = true;
  given.meshes[0].material = 0;
  given.meshes.resize(4, given.meshes[0]);
  given.meshes[1].node = 5;
  given.meshes[3].node = 5;
  const Warnings quiet;
  const AssetData scene = scene_from_arrays(given);
  ASSERT_EQ(scene.primitives.size(), 4u);
  EXPECT_EQ(scene.primitives[1].node, 5);
  EXPECT_EQ(scene.primitives[3].node, 5);
  EXPECT_NE(scene.primitives[0].node, scene.primitives[2].node);
  EXPECT_NE(scene.primitives[0].node, 5);
  EXPECT_NE(scene.primitives[2].node, 5);
  EXPECT_GE(scene.primitives[0].node, 0);
}

// The caller's memory may go away, and be written to.
TEST(ArraysAsGltf, NothingIsBorrowedAfterwards) {
  const Warnings quiet;
  AssetData scene, expected;
  {
    Whole whole;
    expected = scene_from_arrays(whole.given);
    scene = scene_from_arrays(whole.given);
    std::ranges::fill(whole.face.positions_m, std::array<float, 3>{});
    std::ranges::fill(whole.face.indices, 0u);
    for (auto& pixels : whole.pixels) std::ranges::fill(pixels, std::uint8_t{0});
  }
  const Whole again;
  expect_same(scene, scene_from_arrays(again.given));
}

}  // namespace
}  // namespace dermis::scene::test
