// SPDX-License-Identifier: MIT
// Under one lamp the light that a face shows must not step where its unwrap is cut: at most 2/255 more across
// a seam than beside it. Seen from behind, where heads are cut.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "gpu/seams/seam_steps.h"
#include "scene/scene.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

constexpr double bound = 2;  // of 255 display values

// White skin without reflection: what is seen is the light. The lamp goes with the camera, like the rig's key
// light seen from the front.
RenderSettings key_light() {
  constexpr double azimuth_deg = 200;
  RenderSettings s;
  s.width = s.height = 288;
  s.samples = 1;
  s.map_size = s.shadow_size = 512;
  s.orbit_deg = {azimuth_deg, 10};
  s.placed_lights = {{.azimuth_deg = azimuth_deg + 45, .elevation_deg = 35}};
  s.ambient = s.bloom = 0;
  s.specular = false;
  s.white_albedo = true;
  return s;
}

// Fine normals of a file may step at its seams, and so does the light then: here only light counts.
Scene without_maps(const Scene& scene) {
  scene::Scene plain = scene.data();
  for (scene::Material& material : plain.materials) {
    material.normal_map = {};
    material.skin_settings.displacement = {};
  }
  return Scene(std::make_shared<const scene::Scene>(std::move(plain)));
}

Excess measure(const Scene& scene, const std::string& name) {
  static Renderer renderer;
  const RenderSettings s = key_light();
  RenderSettings unmapped = s;
  unmapped.technique = "lambert";

  const Crossings crossings = find_crossings(scene, s);
  const Excess excess = seam_excess(crossings, renderer.render(scene, s), renderer.render(scene, unmapped));
  std::printf(
      "%s: %zu crossings, %zu runs, %+.2f at (%d, %d); left out: %zu in edges of shadows, %zu creased\n",
      name.c_str(), crossings.all.size(), excess.runs, excess.largest, excess.pixel.x, excess.pixel.y,
      crossings.in_shadow_edges, crossings.creased);
  return excess;
}

TEST(Seams, DoNotShowOnTheBuiltInHead) {
  const Excess m = measure(without_maps(Scene::built_in()), "built-in head");
  EXPECT_GE(m.runs, 5u);
  EXPECT_LE(m.largest, bound);
}

TEST(Seams, DoNotShowOnTheScan) {
  const fs::path heads = fs::path(DERMIS_SOURCE_DIR) / "assets" / "heads";
  if (!fs::exists(heads / "LeePerrySmith.glb"))
    GTEST_SKIP() << "the scan is not there; ./run fetch-assets brings it";
  const Excess m = measure(without_maps(Scene::load(heads / "lee-perry-smith.gltf")), "scan");
  EXPECT_GE(m.runs, 5u);
  EXPECT_LE(m.largest, bound);
}

TEST(Seams, DoNotShowOnOtherHeads) {
  const char* cache = std::getenv("DERMIS_ASSET_CACHE");
  const fs::path shared = cache ? fs::path(cache) : fs::path(DERMIS_SOURCE_DIR) / ".." / "shared" / "assets";
  std::size_t heads = 0, runs = 0;
  for (const char* folder : {"makehuman", "makehuman/crowd", "ict-facekit"}) {
    if (!fs::exists(shared / folder)) continue;
    for (const auto& entry : fs::directory_iterator(shared / folder)) {
      if (entry.path().extension() != ".glb") continue;
      const std::string name = entry.path().stem().string();
      const Excess m = measure(without_maps(Scene::load(entry.path())), name);
      EXPECT_LE(m.largest, bound) << name;
      runs += m.runs;
      ++heads;
    }
  }
  if (heads == 0) GTEST_SKIP() << "no heads in " << shared << "; set DERMIS_ASSET_CACHE";
  EXPECT_GT(runs, 10u);
}

// A mesh that is cut open at its seams: a hundredth of a millimetre, too little to be seen, and light no
// longer flows across. The measure must see that.
TEST(Seams, ThatAreCutOpenShow) {
  scene::Scene cut = without_maps(Scene::built_in()).data();
  for (scene::Primitive& primitive : cut.primitives)
    for (scene::Vertex& v : primitive.vertices) v.position_m.y += 2e-5f * (v.uv0.x + 0.7f * v.uv0.y);

  const Excess m = measure(Scene(std::make_shared<const scene::Scene>(std::move(cut))), "cut open");
  EXPECT_GE(m.runs, 5u);
  EXPECT_GT(m.largest, bound);
}

}  // namespace
}  // namespace dermis::tests
