// SPDX-License-Identifier: MIT
// Vertices that triangles share, as the device has them: a picture does not show whether they are shared.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "gpu/device.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/unwrap.h"
#include "render/passes/asset/gpu_asset.h"
#include "render/passes/shaders.h"
#include "support/scenes.h"

namespace dermis::tests {
namespace {

/// Gives each corner of each triangle a vertex of its own, and takes away those without a triangle.
scene::AssetData unshared(scene::AssetData scene) {
  for (scene::Primitive& p : scene.primitives) {
    std::vector<scene::Vertex> vertices;
    for (const std::uint32_t index : p.indices) vertices.push_back(p.vertices[index]);
    p.vertices = std::move(vertices);
    std::iota(p.indices.begin(), p.indices.end(), 0u);
  }
  return scene;
}

/// A sphere with all that meshes may have: mirrored charts, triangles without area, one without a chart,
/// vertices that no triangle has; a sheet beside it that is not skin.
scene::AssetData odd_sphere() {
  scene::AssetData made = scene::sphere(0.1, 6);
  scene::Primitive& p = made.primitives.front();

  for (scene::Vertex& v : p.vertices) {
    if (v.uv0.x < 1.0f / 3) v.uv0.y = 1 - v.uv0.y;
    v.colour = glm::vec4(glm::vec3(0.75f + 0.25f * std::sin(40 * v.position_m.x)), 1);
  }

  const auto without_area = p.indices[17];
  p.indices.insert(p.indices.begin() + 30,
                   {without_area, without_area, p.indices[18], without_area, p.indices[18], without_area});
  p.vertices.insert(p.vertices.begin(), 5, p.vertices.front());
  for (std::uint32_t& index : p.indices) index += 5;
  p.vertices[p.indices[90]].uv0 = glm::vec2(NAN);

  add_sheet(made, 0.2f, -0.05f);
  made.lights.push_back(directional_light(glm::normalize(glm::vec3(-0.4f, -0.5f, -1))));
  return made;
}

RenderSettings vertices_settings(const std::string& technique, bool optimised) {
  RenderSettings s = small_settings(technique, 48, 64);
  s.quality.shadow_size = 64;
  s.camera.orbit_deg = {30, 10};
  return optimised ? s : unoptimised(s);
}

void expect_same(const Picture& shared, const Picture& other) {
  expect_equal_bits(shared, other);
  EXPECT_GT(shared.statistics.skin_pixels, 300u);
  EXPECT_EQ(shared.statistics.irradiance_texels, other.statistics.irradiance_texels);
  EXPECT_EQ(shared.statistics.unshaded_reads, 0u);
  EXPECT_EQ(other.statistics.unshaded_reads, 0u);
}

TEST(Vertices, APictureIsTheSameWhetherTheyAreSharedOrNot) {
  const scene::AssetData made = odd_sphere();
  const Scene shared = wrap(made), other = wrap(unshared(made));
  for (const std::string& technique : technique_names())
    for (const bool optimised : {false, true}) {
      SCOPED_TRACE(technique + (optimised ? " optimised" : ""));
      const RenderSettings s = vertices_settings(technique, optimised);
      expect_same(renderer().render(shared, s), renderer().render(other, s));
    }
}

TEST(Vertices, AsManyAsNoShortNumberHolds) {
  scene::AssetData made = scene::sphere(0.1, 110);
  ASSERT_GT(made.primitives.front().vertices.size(), 65535u);
  made.lights.push_back(directional_light(glm::vec3(0, 0, -1)));
  const Scene shared = wrap(made), other = wrap(unshared(made));
  const RenderSettings s = vertices_settings("texture-space", true);
  expect_same(renderer().render(shared, s), renderer().render(other, s));
}

// Extras that are equal are there once.
TEST(Vertices, APictureIsTheSameWhetherExtrasAreEqualOrNot) {
  scene::AssetData made = scene::sphere(0.1, 6);
  made.lights.push_back(directional_light(glm::vec3(0, 0, -1)));
  scene::Primitive& p = made.primitives.front();
  p.vertices.insert(p.vertices.begin(), p.vertices.front());  // no triangle has it
  for (std::uint32_t& index : p.indices) ++index;
  for (scene::Vertex& v : p.vertices) v.colour = glm::vec4(0.5f, 0.25f, 0.75f, 1);
  const Scene equal = wrap(made);
  p.vertices.front().colour = glm::vec4(1);
  const Scene different = wrap(made);
  for (const std::string& technique : technique_names()) {
    const RenderSettings s = vertices_settings(technique, true);
    expect_same(renderer().render(equal, s), renderer().render(different, s));
  }
}

TEST(Vertices, CulledTrianglesShadeNoTexel) {
  const Scene scene = wrap(odd_sphere());
  RenderSettings s = vertices_settings("texture-space", false);
  const Picture whole = renderer().render(scene, s);
  s.quality.cull = true;
  const Picture culled = renderer().render(scene, s);
  // The back of a sphere, beyond 105 degrees, is 37 % of it; tiles at its border are lit whole.
  const double left = static_cast<double>(culled.statistics.irradiance_texels) /
                      static_cast<double>(whole.statistics.irradiance_texels);
  EXPECT_GT(left, 0.55);
  EXPECT_LT(left, 0.9);
  EXPECT_EQ(culled.statistics.unshaded_reads, 0u);
}

class OnTheDevice : public testing::Test {
 protected:
  static void SetUpTestSuite() { library(); }
  static gpu::PipelineLibrary& library() {
    struct Made {
      gpu::Device device{gpu::Device::Options{.validate = is_validated()}};
      gpu::PipelineLibrary library{device, passes::find_shader};
    };
    static std::unique_ptr<Made> made;
    if (!made) {
      made = std::make_unique<Made>();
      with_the_last_test([] { made.reset(); });
    }
    return made->library;
  }
  static passes::GpuAsset uploaded(scene::AssetData asset) {
    asset.skin = scene::skin_meshes(asset);
    return {library(), asset};
  }
};

constexpr std::size_t number = 4;  // bytes

TEST_F(OnTheDevice, VerticesTakeWhatTheyNeed) {
  const scene::AssetData made = scene::sphere(0.1, 8);
  const scene::SkinMesh skin = scene::skin_meshes(made).front();
  const std::size_t vertices = skin.vertices.size(), triangles = skin.triangle_chart.size();

  const passes::GpuAsset scene = uploaded(made);
  const passes::GpuMesh& mesh = scene.skin.front();
  EXPECT_EQ(mesh.vertices.desc().bytes, 12 * number * vertices);
  EXPECT_EQ(mesh.skin_vertices.desc().bytes, 8 * number * vertices);
  EXPECT_EQ(mesh.vertex_extras.desc().bytes, 8 * number) << "all are white, without a second coordinate";
  EXPECT_EQ(mesh.indices.desc().bytes, 3 * number * triangles);
  EXPECT_EQ(mesh.first_corners.desc().bytes, 3 * number * triangles);

  // 23 numbers per vertex, 4 per triangle: what they took when each draw read all of a vertex; and two
  // numbers for curvature and thickness, which there were not.
  const std::size_t now = mesh.vertices.desc().bytes + mesh.skin_vertices.desc().bytes +
                          mesh.vertex_extras.desc().bytes + mesh.indices.desc().bytes +
                          mesh.first_corners.desc().bytes;
  EXPECT_LT(now, number * (25 * vertices + 4 * triangles));
}

TEST_F(OnTheDevice, ExtrasThatDifferAreThereForEachVertex) {
  scene::AssetData made = scene::sphere(0.1, 8);
  made.primitives.front().vertices.back().uv1.x = 0.5f;
  const std::size_t vertices = scene::skin_meshes(made).front().vertices.size();
  EXPECT_EQ(uploaded(made).skin.front().vertex_extras.desc().bytes, 8 * number * vertices);
}

TEST_F(OnTheDevice, PartsThatAreNotSkinHaveNoUnwrap) {
  const scene::AssetData made = odd_sphere();
  const scene::Primitive& sheet = made.primitives.back();
  const passes::GpuAsset scene = uploaded(made);
  ASSERT_EQ(scene.surfaces.pages.size(), 1u);
  EXPECT_EQ(scene.surfaces.pages[0].vertices.desc().bytes, 12 * number * sheet.vertices.size());
  EXPECT_EQ(scene.surfaces.pages[0].vertex_extras.desc().bytes, 8 * number);
  EXPECT_EQ(scene.surfaces.pages[0].indices.desc().bytes, number * sheet.indices.size());
}

}  // namespace
}  // namespace dermis::tests
