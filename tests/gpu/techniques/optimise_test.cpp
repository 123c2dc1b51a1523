// SPDX-License-Identifier: MIT
// What the three optimisations of [JG08] leave out: counted on the device, counted again here by their rules,
// and not missed in the picture.
#include <glm/glm.hpp>
#include <glm/gtx/component_wise.hpp>

#include "api/scene_state.h"
#include "base/settings/names.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "head/scene/framing.h"
#include "head/scene/surface/coverage.h"
#include "render/shared/tiles_io.h"
#include "render/techniques/sides_by_need.h"

namespace dermis::tests {
namespace {

constexpr int side = 512;

RenderSettings settings_with(bool cull, bool depth, bool clip) {
  RenderSettings s = small_settings("texture-space");
  s.quality.map_size = side;
  s.quality.cull = cull, s.quality.depth = depth, s.quality.clip = clip;
  return s;
}

constexpr float tile_reach = 1;  // texels: render/passes/light_map/tiles/seen_tiles.comp

// Texels of the map that triangles cover, in the tiles that triangles touch which `kept(triangle)` accepts.
template <class Kept>
std::size_t count_texels(const scene::SkinMesh& mesh, const Kept& kept) {
  std::vector<bool> covered(static_cast<std::size_t>(side) * side), lit(covered.size());
  const auto tile = [](int x, int y) {
    return static_cast<std::size_t>(y / TILE_SIDE) * side + static_cast<std::size_t>(x / TILE_SIDE);
  };
  for (std::size_t t = 0; t < mesh.triangle_chart.size(); ++t) {
    const std::array<glm::vec2, 3> uv = scene::triangle_uv(mesh, t);
    scene::for_each_texel(uv, side, [&](int x, int y) {
      covered[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)] = true;
    });
    if (!kept(t)) continue;

    const auto texel = [](const glm::vec2& at) { return glm::ivec2(glm::clamp(at, 0.0f, side - 1.0f)); };
    const glm::ivec2 low = texel(glm::min(uv[0], glm::min(uv[1], uv[2])) * float{side} - tile_reach),
                     high = texel(glm::max(uv[0], glm::max(uv[1], uv[2])) * float{side} + tile_reach);
    for (int y = low.y / TILE_SIDE * TILE_SIDE; y <= high.y; y += TILE_SIDE)
      for (int x = low.x / TILE_SIDE * TILE_SIDE; x <= high.x; x += TILE_SIDE) lit[tile(x, y)] = true;
  }

  std::size_t count = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      count += covered[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)] && lit[tile(x, y)];
  return count;
}

const scene::Vertex& corner(const scene::SkinMesh& mesh, std::size_t triangle, int k) {
  return mesh.vertices[mesh.indices[3 * triangle + static_cast<std::size_t>(k)]];
}

// All three vertices more than 105 degrees from the direction to the eye, and the triangle seen from behind.
bool culled(const scene::SkinMesh& mesh, std::size_t t, const glm::dvec3& eye) {
  glm::dvec3 p[3];
  for (int k = 0; k < 3; ++k) {
    p[k] = corner(mesh, t, k).position_m;
    const glm::dvec3 n = glm::normalize(glm::dvec3(corner(mesh, t, k).normal));
    if (glm::dot(n, glm::normalize(eye - p[k])) >= std::cos(glm::radians(105.0))) return false;
  }
  return glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), eye - p[0]) < 0;
}

// A few tiles more are lit: those from which texels beside charts take their light.
void expect_texels(const Statistics& st, std::size_t expected) {
  EXPECT_GE(static_cast<double>(st.irradiance_texels), 0.999 * static_cast<double>(expected));
  EXPECT_LE(static_cast<double>(st.irradiance_texels), 1.05 * static_cast<double>(expected));
}

class OnTheScan : public WithScan {
 protected:
  void SetUp() override {
    WithScan::SetUp();
    if (IsSkipped()) return;
    const std::vector<scene::SkinMesh>& meshes = api::only_asset(scan()).skin;
    ASSERT_EQ(meshes.size(), 1u);
    mesh = &meshes.front();
    sphere = api::only_asset(scan()).bounds.sphere;
  }
  const scene::SkinMesh* mesh = nullptr;
  scene::BoundingSphere sphere;
};

TEST_F(OnTheScan, CullLeavesWhatTheRuleLeaves) {
  RenderSettings s = settings_with(true, false, false);
  s.camera.orbit_deg = {0.001, 0};  // the framing camera instead of the scene's
  const glm::dvec3 eye(scene::framing_camera(sphere, 1, 0.001, 0).world_from_camera[3]);
  const std::size_t expected = count_texels(*mesh, [&](std::size_t t) { return !culled(*mesh, t, eye); });
  const std::size_t all = count_texels(*mesh, [](std::size_t) { return true; });
  const Statistics st = renderer().render(scan(), s).statistics;
  expect_texels(st, expected);
  EXPECT_LT(static_cast<double>(expected), 0.8 * static_cast<double>(all));
  EXPECT_EQ(st.unshaded_reads, 0u);
}

TEST_F(OnTheScan, ClipLeavesWhatLiesInThePyramid) {
  // Where nothing is said, light arrives from as far as the widest Gaussian of the published skin reaches.
  constexpr double widest_mm2 = 7.41;
  for (const std::optional<double> wanted_mm :
       {std::optional(0.0), std::optional(4.0), std::optional<double>()}) {
    const double margin_mm = wanted_mm.value_or(3 * std::sqrt(widest_mm2));
    RenderSettings s = settings_with(false, false, true);
    s.output.width = 192;
    s.camera.distance = 2.5;
    s.quality.clip_margin_mm = wanted_mm;

    const glm::dmat4 camera_from_world =
        glm::inverse(glm::dmat4(scene::distance_camera(sphere, 2.5).world_from_camera));
    const double slope_y = std::tan(glm::radians(10.0)), slope_x = slope_y * 192 / 128;

    // A triangle is kept unless all of it is further outside one side of the pyramid.
    const auto kept = [&](std::size_t t) {
      glm::dvec4 furthest_inside(-1e9);
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 q = camera_from_world * glm::dvec4(corner(*mesh, t, k).position_m, 1);
        furthest_inside = glm::max(
            furthest_inside, glm::dvec4((-q.z * slope_x + glm::dvec2(q.x, -q.x)) / std::hypot(1, slope_x),
                                        (-q.z * slope_y + glm::dvec2(q.y, -q.y)) / std::hypot(1, slope_y)));
      }
      return glm::compMin(furthest_inside) >= -margin_mm * 0.001;
    };

    const std::size_t expected = count_texels(*mesh, kept),
                      all = count_texels(*mesh, [](auto) { return true; });
    const Statistics st = renderer().render(scan(), s).statistics;
    expect_texels(st, expected);
    EXPECT_LT(static_cast<double>(expected), 0.85 * static_cast<double>(all));
  }
}

TEST_F(OnTheScan, DepthTakesTheMapThatTheNearestPointNeeds) {
  glm::dvec3 low(1e9), high(-1e9);
  for (const std::uint32_t i : mesh->indices) {
    low = min(low, glm::dvec3(mesh->vertices[i].position_m));
    high = max(high, glm::dvec3(mesh->vertices[i].position_m));
  }

  const double uv_per_mm = scene::unwrap_density(*mesh, 1000).uv_per_mm.mean;
  PreparedFrame frame = renderer().prepare(scan(), settings_with(false, true, false));
  for (const double distance : {2.5, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    RenderSettings s = settings_with(false, true, false);
    s.camera.distance = distance;
    frame.set(s);
    const Statistics st = frame.picture().statistics;

    const glm::dvec3 eye(scene::distance_camera(sphere, distance).world_from_camera[3]);
    const double d = glm::distance(eye, glm::clamp(eye, low, high)) / sphere.radius_m;
    // The narrowest of the two wide terms that spreads light over enough pixels takes 0.9 texels, or 0.7
    // below 1.2 pixels.
    const double pixels_per_mm = st.d_ref / d * uv_per_mm * side;
    const auto texels_of = [&](double sigma_mm) {
      return (sigma_mm * pixels_per_mm < 1.2 ? 0.7 : 0.9) / (sigma_mm * uv_per_mm);
    };
    const double needed = std::sqrt(1.99) * pixels_per_mm > 0.6    ? texels_of(std::sqrt(1.99))
                          : std::sqrt(7.41) * pixels_per_mm > 0.35 ? texels_of(std::sqrt(7.41))
                                                                   : 0;
    int expected = side;
    for (const std::uint32_t smaller : techniques::sides_by_need(side))
      if (smaller >= needed) expected = static_cast<int>(smaller);
    ASSERT_EQ(st.used_size, std::vector<int>{expected}) << distance;

    std::vector<bool> covered(static_cast<std::size_t>(expected) * static_cast<std::size_t>(expected));
    for (std::size_t t = 0; t < mesh->triangle_chart.size(); ++t)
      scene::for_each_texel(scene::triangle_uv(*mesh, t), expected, [&](int x, int y) {
        covered[static_cast<std::size_t>(y) * static_cast<std::size_t>(expected) +
                static_cast<std::size_t>(x)] = true;
      });

    // Where no term is read from the map, nothing is lit on it.
    ASSERT_EQ(st.mapped_terms.size(), 1u);
    const auto texels = st.mapped_terms.front() == 0
                            ? 0
                            : static_cast<double>(std::count(covered.begin(), covered.end(), true));
    EXPECT_NEAR(static_cast<double>(st.irradiance_texels), texels, 0.001 * texels) << distance;
  }
}

// The picture of tiles that hold light is that of all tiles.
TEST_F(OnTheScan, TilesWithoutLightAreNotBlurred) {
  RenderSettings s = settings_with(true, true, true);
  s.camera.orbit_deg = {50, 10};
  const Picture seen = renderer().render(scan(), s);
  EXPECT_EQ(seen.statistics.mask, "tiles");
  s.quality.cull = s.quality.clip = false;
  const Picture all = renderer().render(scan(), s);
  EXPECT_EQ(all.statistics.mask, "");
  EXPECT_LT(seen.statistics.launched, all.statistics.launched);
  expect_unseen(all, seen);
}

}  // namespace
}  // namespace dermis::tests
