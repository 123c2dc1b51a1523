// SPDX-License-Identifier: MIT
// Arrays that are no scene end in one InputError that names asset, object and member, before memory is taken.
#include <cmath>
#include <functional>
#include <limits>

#include "head/scene/arrays/from_arrays.h"
#include "head/scene/import/limits.h"
#include "support.h"
#include "support/thrown.h"

namespace dermis::scene::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

/// A triangle of skin with one picture, which every case spoils in one way.
struct Good {
  OwnedMesh mesh{.positions_m = {{0, 0, 0}, {0.2f, 0, 0}, {0, 0.2f, 0}},
                 .normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                 .tangents = {{1, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}},
                 .colours = {{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}},
                 .uv0 = {{0, 0}, {1, 0}, {0, 1}},
                 .uv1 = {{0, 0}, {1, 0}, {0, 1}},
                 .indices = {0, 1, 2}};
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(4 * 4 * 3, 100);
  AssetArrays given;

  Good() {
    given.name = "hero";
    given.images = {{.name = "skin.png", .width = 4, .height = 4, .channels = 3, .pixels = pixels}};
    given.materials.resize(1);
    given.materials[0].name = "skin";
    given.materials[0].skin = true;
    given.materials[0].base_colour_map.image = 0;
    given.meshes.resize(1);
    given.meshes[0].name = "face";
    given.meshes[0].material = 0;
    mesh.lend(given.meshes[0]);
  }
  Good(const Good&) = delete;
  Good& operator=(const Good&) = delete;

  AssetMesh& face() { return given.meshes[0]; }
  AssetMaterial& skin() { return given.materials[0]; }
  AssetImage& image() { return given.images[0]; }
};

struct Case {
  std::function<void(Good&)> spoil;
  std::string message;
};

void expect_refused(const std::vector<Case>& cases, const LoadOptions& options = {}) {
  for (const Case& bad : cases) {
    const Warnings quiet;
    Good good;
    bad.spoil(good);
    EXPECT_EQ(tests::thrown<InputError>([&] { scene_from_arrays(good.given, options); }),
              "hero: " + bad.message);
  }
}

TEST(ArraysHostile, TheGoodOneIsTaken) {
  Good good;
  const Warnings warnings;
  EXPECT_EQ(scene_from_arrays(good.given).primitives.size(), 1u);
  EXPECT_EQ(warnings.all(), "");
}

TEST(ArraysHostile, Meshes) {
  expect_refused({
      {[](Good& g) { g.given.meshes.clear(); }, "there are no triangles to draw"},
      {[](Good& g) { g.face() = {.name = "face"}; }, "mesh 0 'face': has no triangles: positions_m is empty"},
      {[](Good& g) { g.face().positions_m = {}; },
       "mesh 0 'face': normals has 3 elements, positions_m has 0"},
      {[](Good& g) { g.face().normals = g.face().normals.first(2); },
       "mesh 0 'face': normals has 2 elements, positions_m has 3"},
      {[](Good& g) { g.face().tangents = g.face().tangents.first(1); },
       "mesh 0 'face': tangents has 1 elements, positions_m has 3"},
      {[](Good& g) { g.face().uv0 = g.face().uv0.first(2); },
       "mesh 0 'face': uv0 has 2 elements, positions_m has 3"},
      {[](Good& g) { g.face().uv1 = g.face().uv1.first(2); },
       "mesh 0 'face': uv1 has 2 elements, positions_m has 3"},
      {[](Good& g) { g.face().colours = g.face().colours.first(2); },
       "mesh 0 'face': colours has 2 elements, positions_m has 3"},
      {[](Good& g) { g.face().indices = g.face().indices.first(2); },
       "mesh 0 'face': indices has 2 elements, expected three per triangle"},
      {[](Good& g) { g.face() = {.name = "face", .positions_m = std::span(g.mesh.positions_m).first(2)}; },
       "mesh 0 'face': positions_m has 2 elements, expected three per triangle"},
      {[](Good& g) { g.mesh.indices[1] = 3; }, "mesh 0 'face': index 1 is 3, there are 3 vertices"},
      {[](Good& g) { g.mesh.indices[2] = 0xffffffffu; },
       "mesh 0 'face': index 2 is 4294967295, there are 3 vertices"},
      {[](Good& g) { g.mesh.positions_m[1][2] = nan; },
       "mesh 0 'face': positions_m of vertex 1 is not finite"},
      {[](Good& g) { g.mesh.positions_m[2][0] = -inf; },
       "mesh 0 'face': positions_m of vertex 2 is not finite"},
      {[](Good& g) { g.mesh.positions_m[2][0] = 2e6f; },
       "mesh 0 'face': vertex 2 lies at (2000000, 0.2, 0) m, more than 1000000 m from the origin"},
      {[](Good& g) { g.mesh.uv0[0][1] = nan; }, "mesh 0 'face': uv0 of vertex 0 is not finite"},
      {[](Good& g) { g.mesh.uv1[1][0] = inf; }, "mesh 0 'face': uv1 of vertex 1 is not finite"},
      {[](Good& g) { g.mesh.uv1[1][0] = 1e9f; },
       "mesh 0 'face': texture coordinates (1000000000, 0) of vertex 1 are out of range"},
      {[](Good& g) { g.mesh.colours[1][3] = nan; }, "mesh 0 'face': colours of vertex 1 is not finite"},
      {[](Good& g) { g.face().material = 1; },
       "mesh 0 'face': material is 1, there are 1 materials (-1 for none)"},
      {[](Good& g) { g.face().material = -2; },
       "mesh 0 'face': material is -2, there are 1 materials (-1 for none)"},
      {[](Good& g) { g.face().node = 1'000'000'000; },
       "mesh 0 'face': node must be -1 to 1000000, got 1000000000"},
      {[](Good& g) { g.face().node = -7; }, "mesh 0 'face': node must be -1 to 1000000, got -7"},
      {[](Good& g) {
         g.face().name = "";
         g.mesh.indices[0] = 9;
       },
       "mesh 0: index 0 is 9, there are 3 vertices"},
      {[](Good& g) {
         g.face().name = "two\nlines";
         g.mesh.indices[0] = 9;
       },
       "mesh 0 'two?lines': index 0 is 9, there are 3 vertices"},
  });
}

// A span may claim what no memory holds: nothing of it is read where a count alone is wrong.
TEST(ArraysHostile, CountsComeBeforeContents) {
  const auto claim = [](auto span, std::size_t count) { return decltype(span)(span.data(), count); };
  expect_refused({
      {[&](Good& g) {
         g.face().positions_m = claim(g.face().positions_m, 3'000'000'000);
         g.face() = {.name = "face", .positions_m = g.face().positions_m};
       },
       "has more than 20000000 triangles, the limit"},
      {[&](Good& g) { g.face().indices = claim(g.face().indices, 3'000'000'000); },
       "has more than 20000000 triangles, the limit"},
      {[&](Good& g) {
         g.face() = {.name = "face",
                     .positions_m = claim(g.face().positions_m, 70'000'000),
                     .indices = g.face().indices};
       },
       "has more than 60000000 vertices, the limit"},
  });
  expect_refused(
      {{[](Good& g) { g.given.meshes.resize(3, g.face()); }, "has more than 2 triangles, the limit"}},
      {.max_triangles = 2});
}

TEST(ArraysHostile, UnitsCountForPositions) {
  expect_refused({{[](Good& g) { g.mesh.positions_m[1][0] = 2000; },
                   "mesh 0 'face': vertex 1 lies at (2000000, 0, 0) m, more than 1000000 m from the origin"}},
                 {.unit_scale = 1000});
}

TEST(ArraysHostile, Images) {
  const auto of_size = [](int width, int height, int channels = 3) {
    return [=](Good& g) {
      g.image().width = width;
      g.image().height = height;
      g.image().channels = channels;
    };
  };
  expect_refused({
      {of_size(0, 4), "image 0 'skin.png': is 0 x 4 pixels, expected 1 to 16384 each way"},
      {of_size(4, -4), "image 0 'skin.png': is 4 x -4 pixels, expected 1 to 16384 each way"},
      {of_size(1'000'000'000, 1'000'000'000),
       "image 0 'skin.png': is 1000000000 x 1000000000 pixels, expected 1 to 16384 each way"},
      {of_size(16385, 1), "image 0 'skin.png': is 16385 x 1 pixels, expected 1 to 16384 each way"},
      {of_size(4, 4, 0), "image 0 'skin.png': channels must be 1 to 4, got 0"},
      {of_size(4, 4, 5), "image 0 'skin.png': channels must be 1 to 4, got 5"},
      {of_size(4, 5), "image 0 'skin.png': pixels has 48 bytes, expected 60 for 4 x 5 pixels of 3 channels"},
      {of_size(16384, 16384, 4),
       "image 0 'skin.png': pixels has 48 bytes, expected 1073741824 for 16384 x 16384 pixels of 4 channels"},
      {[](Good& g) { g.image().pixels = {}; },
       "image 0 'skin.png': pixels has 0 bytes, expected 48 for 4 x 4 pixels of 3 channels"},
  });
  expect_refused({{[](Good&) {}, "its 1 maps do not fit into the texture budget of 1 bytes"}},
                 {.texture_budget_mb = 1e-6});
}

TEST(ArraysHostile, FactorsOfMaterials) {
  const std::string at = "material 0 'skin': ";
  expect_refused({
      {[](Good& g) { g.skin().base_colour[2] = -0.5f; }, at + "base_colour must be 0 to 1, got -0.5"},
      {[](Good& g) { g.skin().base_colour[3] = nan; }, at + "base_colour must be 0 to 1, got nan"},
      {[](Good& g) { g.skin().metallic = 2; }, at + "metallic must be 0 to 1, got 2"},
      {[](Good& g) { g.skin().roughness = -1; }, at + "roughness must be 0 to 1, got -1"},
      {[](Good& g) { g.skin().normal_scale = inf; }, at + "normal_scale must be finite, got inf"},
      {[](Good& g) { g.skin().occlusion_strength = 1.5f; },
       at + "occlusion_strength must be 0 to 1, got 1.5"},
      {[](Good& g) { g.skin().emissive[0] = -1; }, at + "emissive must be 0 to 1000000, got -1"},
      {[](Good& g) { g.skin().emissive[2] = inf; }, at + "emissive must be 0 to 1000000, got inf"},
      {[](Good& g) { g.skin().ior = 0.5f; }, at + "ior must be 1 to 100, got 0.5"},
      {[](Good& g) { g.skin().ior = nan; }, at + "ior must be 1 to 100, got nan"},
      {[](Good& g) { g.skin().specular = -1; }, at + "specular must be 0 to 1, got -1"},
      {[](Good& g) { g.skin().specular_colour[1] = 2e6f; },
       at + "specular_colour must be 0 to 1000000, got 2000000"},
      {[](Good& g) { g.skin().alpha_cutoff = -1; }, at + "alpha_cutoff must be 0 to 1000000, got -1"},
      {[](Good& g) { g.skin().alpha = static_cast<AssetAlpha>(9); }, at + "alpha is no known mode: 9"},
  });
}

TEST(ArraysHostile, MapsOfMaterials) {
  const std::string at = "material 0 'skin': ";
  expect_refused({
      {[](Good& g) { g.skin().base_colour_map.image = 1; },
       at + "base_colour_map.image is 1, there are 1 images (-1 for none)"},
      {[](Good& g) { g.skin().normal_map.image = -2; },
       at + "normal_map.image is -2, there are 1 images (-1 for none)"},
      {[](Good& g) { g.skin().occlusion_map.uv_set = 2; }, at + "occlusion_map.uv_set must be 0 or 1, got 2"},
      {[](Good& g) { g.skin().emissive_map.uv_set = -1; }, at + "emissive_map.uv_set must be 0 or 1, got -1"},
      {[](Good& g) { g.skin().metallic_roughness_map.transform[1][0] = nan; },
       at + "metallic_roughness_map.transform must be finite, has nan"},
      {[](Good& g) { g.skin().specular_map.wrap_v = static_cast<AssetWrap>(3); },
       at + "specular_map wraps in no known way: 3"},
      {[](Good& g) { g.skin().specular_colour_map.image = 7; },
       at + "specular_colour_map.image is 7, there are 1 images (-1 for none)"},
      {[](Good& g) { g.skin().skin_settings.specular.map.image = 7; },
       at + "specular.image is 7, there are 1 images (-1 for none)"},
      {[](Good& g) { g.skin().skin_settings.specular.channel = 4; },
       at + "specular.channel must be 0 to 3, got 4"},
      {[](Good& g) { g.skin().skin_settings.roughness.channel = -1; },
       at + "roughness.channel must be 0 to 3, got -1"},
      {[](Good& g) { g.skin().skin_settings.roughness.scale = -1; },
       at + "roughness.scale must be 0 to 1000, got -1"},
      {[](Good& g) { g.skin().skin_settings.displacement.image = 3; },
       at + "displacement.image is 3, there are 1 images (-1 for none)"},
      {[](Good& g) { g.skin().skin_settings.detail.image = 1; },
       at + "detail.image is 1, there are 1 images (-1 for none)"},
  });
}

TEST(ArraysHostile, Skin) {
  const std::string at = "material 0 'skin': ";
  const auto with = [](const auto& change) { return [=](Good& g) { change(g.skin().skin_settings); }; };
  expect_refused({
      {with([](AssetSkin& s) { s.mix = 1.5f; }), at + "mix must be 0 to 1, got 1.5"},
      {with([](AssetSkin& s) { s.mix = nan; }), at + "mix must be 0 to 1, got nan"},
      {with([](AssetSkin& s) { s.displacement_mm = -1; }), at + "displacement_mm must be 0 to 100, got -1"},
      {with([](AssetSkin& s) { s.displacement_middle = 2; }),
       at + "displacement_middle must be 0 to 1, got 2"},
      {with([](AssetSkin& s) { s.detail_scale = 11; }), at + "detail_scale must be 0 to 10, got 11"},
      {with([](AssetSkin& s) { s.detail_scale = nan; }), at + "detail_scale must be 0 to 10, got nan"},
      {with([](AssetSkin& s) { s.lobes.resize(3); }), at + "lobes must be 1 or 2, got 3"},
      {with([](AssetSkin& s) {
         s.lobes = {{0, 1}};
       }),
       at + "the roughness_factor of a lobe must be over 0 and up to 100, got 0"},
      {with([](AssetSkin& s) {
         s.lobes = {{nan, 1}};
       }),
       at + "the roughness_factor of a lobe must be over 0 and up to 100, got nan"},
      {with([](AssetSkin& s) {
         s.lobes = {{1, -0.5f}, {1, 1.5f}};
       }),
       at + "the weight of a lobe must be 0 to 1, got -0.5"},
      {with([](AssetSkin& s) {
         s.lobes = {{1, 0.5f}, {1, 0.25f}};
       }),
       at + "the weights of the lobes must sum to 1, they sum to 0.75"},
      {with([](AssetSkin& s) { s.profile.emplace(); }), at + "profile: terms must be 1 to 8, there are 0"},
      {with([](AssetSkin& s) {
         s.profile.emplace();
         s.profile->terms = {{1, {1, 0.5, 1}}};
       }),
       at + "profile: weights of green must sum to 1 within 0.001, they sum to 0.5"},
  });
  expect_refused({{[](Good&) {}, "no material is called 'leather'; there are: skin"}},
                 {.skin_material = {"leather"}});
  expect_refused(
      {{[](Good& g) {
          g.face().node = -1;
          g.given.meshes.resize(most_skin_nodes + 1, g.face());
        },
        "has 1025 nodes of skin, each with a light map of its own, and at most 1024 can be drawn. Join "
        "their meshes, or name another material with skin_material"}});
}

TEST(ArraysHostile, AnAssetWithoutAName) {
  Good good;
  good.given.name = "";
  good.skin().metallic = 3;
  EXPECT_EQ(tests::thrown<InputError>([&] { scene_from_arrays(good.given); }),
            "asset: material 0 'skin': metallic must be 0 to 1, got 3");
  good.skin().metallic = 0;
  good.given.name = "two\nlines";
  good.given.meshes.clear();
  EXPECT_EQ(tests::thrown<InputError>([&] { scene_from_arrays(good.given); }),
            "two?lines: there are no triangles to draw");
}

}  // namespace
}  // namespace dermis::scene::test
