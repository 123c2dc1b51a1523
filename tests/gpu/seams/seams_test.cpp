// SPDX-License-Identifier: MIT
// Under one lamp the light that a face shows must not step where its unwrap is cut: at most 2/255 more across
// a seam than beside it. Seen from behind, where heads are cut, and from above, where these cuts and those of
// the crown end.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "api/scene_state.h"
#include "gpu/seams/seam_steps.h"
#include "gpu/support/heads.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/asset_data.h"
#include "support/assets.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

constexpr double bound = 2;  // of 255 display values

struct View {
  const char* name;
  double azimuth_deg, elevation_deg;
};
constexpr View behind{"behind", 200, 10}, above{"above", 160, 55};

// White skin without reflection: what is seen is the light. The lamp goes with the camera, like the rig's key
// light seen from the front.
RenderSettings key_light(const View& view) {
  RenderSettings s;
  s.output.width = s.output.height = 288;
  s.quality.samples = 1;
  s.quality.map_size = s.quality.shadow_size = 512;
  s.camera.orbit_deg = {view.azimuth_deg, view.elevation_deg};
  s.lighting.placed_lights = {{.azimuth_deg = view.azimuth_deg + 45, .elevation_deg = 35}};
  return under_lamps_alone(s);
}

// Fine normals of a file may step at its seams, and so does the light then: here only light counts.
Scene without_maps(const Scene& scene) {
  scene::AssetData plain = api::only_asset(scene);
  for (scene::Material& material : plain.materials) {
    material.normal_map = {};
    material.skin_settings.displacement = {};
  }
  return wrap(std::move(plain));
}

Picture unscattered(const Scene& scene, RenderSettings s) {
  s.technique = "lambert";
  return renderer().render(scene, s);
}

void print(const std::string& name, const Crossings& crossings, const Excess& excess) {
  std::printf(
      "%s: %zu crossings, %zu runs, %+.2f at (%d, %d); left out: %zu in edges of shadows, %zu creased\n",
      name.c_str(), crossings.all.size(), excess.runs, excess.largest, excess.pixel.x, excess.pixel.y,
      crossings.in_shadow_edges, crossings.creased);
}

// The light from both views; returns how many runs of seams were long enough.
std::size_t expect_no_seam(const Scene& scene, const std::string& name) {
  std::size_t runs = 0;
  for (const View& view : {behind, above}) {
    const RenderSettings s = key_light(view);
    const Crossings crossings = find_crossings(scene, s);
    const Excess excess = seam_excess(crossings, renderer().render(scene, s), unscattered(scene, s));
    print(name + ", " + view.name, crossings, excess);
    EXPECT_LE(excess.largest, bound) << name << " from " << view.name;
    runs += excess.runs;
  }
  return runs;
}

// The skin's own colour: what is filtered twice, before the light is scattered and after, and half of it in
// the light map, where a chart's colour could bleed into the next. The colour map is cut where the unwrap is
// and may step there by itself, so a step counts for what it exceeds that of the same picture without
// scattering, which shows the same colours.
void expect_no_seam_in_colour(const Scene& scene, const std::string& name) {
  for (const View& view : {behind, above}) {
    RenderSettings s = key_light(view);
    s.lighting.white_albedo = false;
    const Crossings crossings = find_crossings(scene, s);
    const Excess excess = seam_excess(crossings, renderer().render(scene, s), unscattered(scene, s));
    print(name + ", its own colour, " + view.name, crossings, excess);
    EXPECT_GE(excess.runs, 5u);
    EXPECT_LE(excess.largest, bound) << name << " from " << view.name;
  }
}

const Scene& built_in_head() {
  static const Scene head = without_maps(subject("built-in head").open());
  return head;
}

using SeamsOfTheScan = WithScan;

TEST(Seams, DoNotShowOnTheBuiltInHead) {
  EXPECT_GE(expect_no_seam(built_in_head(), "built-in head"), 5u);
  expect_no_seam_in_colour(built_in_head(), "built-in head");
}

TEST_F(SeamsOfTheScan, DoNotShow) {
  const Scene plain = without_maps(scan());
  EXPECT_GE(expect_no_seam(plain, "scan"), 10u);
  expect_no_seam_in_colour(plain, "scan");
}

TEST(Seams, DoNotShowOnOtherHeads) {
  const fs::path shared = asset_cache();
  std::size_t heads = 0, runs = 0;
  for (const char* folder : {"makehuman", "makehuman/crowd", "ict-facekit"}) {
    if (!fs::exists(shared / folder)) continue;
    for (const auto& entry : fs::directory_iterator(shared / folder)) {
      if (entry.path().extension() != ".glb") continue;
      runs += expect_no_seam(without_maps(Scene::load(entry.path())), entry.path().stem().string());
      ++heads;
    }
  }
  if (heads == 0) GTEST_SKIP() << "no heads in " << shared << "; set DERMIS_ASSET_CACHE";
  EXPECT_GT(runs, 20u);
}

// One side of the seam read a texel or two off in the light map: what a wrong origin, a wrong half texel or a
// light map of another size would do. The measure must see that.
TEST(Seams, OfAChartThatIsReadATexelOrTwoOffShow) {
  const RenderSettings s = key_light(behind);
  const Crossings crossings = find_crossings(built_in_head(), s);
  const Picture picture = renderer().render(built_in_head(), s);
  const Picture unmapped = unscattered(built_in_head(), s);

  for (const int texels : {0, 1, 2}) {
    const Picture shifted = read_off(built_in_head(), s, picture, texels);
    const Excess excess = seam_excess(crossings, shifted, unmapped);
    print(std::to_string(texels) + " texels off", crossings, excess);
    EXPECT_EQ(excess.largest > bound, texels > 0);
  }
}

// A mesh that is cut open at its seams: a hundredth of a millimetre, too little to be seen, and light no
// longer flows across. The measure must see that.
TEST(Seams, ThatAreCutOpenShow) {
  scene::AssetData cut = api::only_asset(built_in_head());
  for (scene::Primitive& primitive : cut.primitives)
    for (scene::Vertex& v : primitive.vertices) v.position_m.y += 2e-5f * (v.uv0.x + 0.7f * v.uv0.y);

  const Scene scene = wrap(std::move(cut));
  const RenderSettings s = key_light(behind);
  const Crossings crossings = find_crossings(scene, s);
  const Excess excess = seam_excess(crossings, renderer().render(scene, s), unscattered(scene, s));
  print("cut open", crossings, excess);
  EXPECT_GE(excess.runs, 5u);
  EXPECT_GT(excess.largest, bound);
}

}  // namespace
}  // namespace dermis::tests
