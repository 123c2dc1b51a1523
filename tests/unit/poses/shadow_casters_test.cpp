// SPDX-License-Identifier: MIT
// What shadow maps are fitted to while a head moves.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "../gltf/support.h"
#include "api/rig_pose.h"
#include "head/scene/framing.h"
#include "head/scene/gltf/load.h"
#include "head/scene/surface/measured.h"
#include "render/passes/shadow/fit.h"
#include "render/setup/casters.h"
#include "support/thrown.h"

namespace dermis::scene::test {
namespace {

constexpr int map_size = 1024;

std::vector<glm::vec3> vertices_of(const AssetData& scene) {
  std::vector<glm::vec3> points_m;
  for (const Primitive& primitive : scene.primitives)
    for (const Vertex& v : primitive.vertices) points_m.push_back(v.position_m);
  return points_m;
}

std::vector<glm::vec3> posed_vertices(const AssetData& scene, const setup::PosedAsset& posed) {
  AssetData moved = scene;
  take_pose(*scene.rig, posed.rig, moved);
  return vertices_of(moved);
}

// Returns the place in the map, in texels, and in z the depth.
glm::vec3 in_map(const passes::ShadowFit& fit, const glm::vec3& p_m) {
  const glm::vec4 clip = fit.shadow_from_world.at(0) * glm::vec4(p_m, 1);
  return {0.5f * map_size * (glm::vec2(clip) / clip.w + 1.0f), clip.z / clip.w};
}

// What is asked of the maps of a clip under one light.
class Steady {
 public:
  void add(const passes::ShadowFit& fit, const std::vector<glm::vec3>& vertices_m) {
    glm::vec2 low(INFINITY), high(-INFINITY);
    for (const glm::vec3& p_m : vertices_m) {
      const glm::vec3 at = in_map(fit, p_m);
      low = glm::min(low, glm::vec2(at));
      high = glm::max(high, glm::vec2(at));
      EXPECT_GT(at.z, 0);
      EXPECT_LT(at.z, 1);
    }
    EXPECT_GE(std::min(low.x, low.y), 3) << "the filter reads three texels";
    EXPECT_LE(std::max(high.x, high.y), map_size - 3);
    least_used_ = std::min(least_used_, std::max(high.x - low.x, high.y - low.y) / map_size);
    expect_same_texels(fit, vertices_m);
  }

  std::size_t sizes() const { return sizes_.size(); }
  float least_used() const { return least_used_; }

 private:
  // As long as the size stays, places that do not move are shifted by whole texels.
  void expect_same_texels(const passes::ShadowFit& fit, const std::vector<glm::vec3>& vertices_m) {
    sizes_.insert(fit.texel);
    if (last_ && last_->texel == fit.texel)
      for (const std::size_t i : {std::size_t{0}, vertices_m.size() / 2}) {
        const glm::vec2 shift(in_map(fit, vertices_m[i]) - in_map(*last_, vertices_m[i]));
        EXPECT_LE(glm::length(shift - glm::round(shift)), 0.02f);
      }
    last_ = fit;
  }

  std::set<float> sizes_;
  float least_used_ = INFINITY;
  std::optional<passes::ShadowFit> last_;
};

std::vector<Light> lights_around(const BoundingSphere& sphere) {
  std::vector<Light> lights;
  for (const double azimuth_deg : {-70.0, 60.0})
    for (const double elevation_deg : {-10.0, 20.0}) {
      const glm::vec3 towards(head_direction(azimuth_deg, elevation_deg));
      Light& sun = lights.emplace_back();
      sun.type = LightType::directional;
      sun.direction = -towards;
      Light& lamp = lights.emplace_back();
      lamp.type = LightType::point;
      lamp.position_m = sphere.centre_m + 3 * sphere.radius_m * towards;
    }
  return lights;
}

// Edges of shadows crawl where texels move over what stands still: over a clip of 48 frames they are shifted
// by whole texels and change their size a few times, hold all vertices, and are hardly larger than need be.
void expect_steady_texels(const fs::path& file) {
  const Warnings quiet;
  const std::shared_ptr<const AssetData> asset = measured(load_gltf(file));
  const std::vector<Light> lights = lights_around(asset->casters);
  std::vector<Steady> found(lights.size());

  for (int frame = 0; frame < 48; ++frame) {
    const auto posed = api::posed_asset(*asset, RigPose{.clip = ClipTime{"", frame / 8.0}});
    const std::vector<glm::vec3> vertices_m = posed_vertices(*asset, *posed);
    const setup::Casters casters(*asset, posed.get(), {});
    for (std::size_t i = 0; i < lights.size(); ++i)
      found[i].add(passes::fit_shadow(lights[i], casters.bounds(), map_size), vertices_m);
  }

  std::size_t sizes = 0;
  float least_used = 1;
  for (const Steady& of_light : found) {
    sizes = std::max(sizes, of_light.sizes());
    least_used = std::min(least_used, of_light.least_used());
  }
  std::printf("%s, 48 frames: at most %zu sizes under a light; vertices fill %.2f of a map or more\n",
              asset->name.c_str(), sizes, static_cast<double>(least_used));
  EXPECT_LE(sizes, 6u);
  // Boxes of what moves are up to 15 % wider than it, sides up to 4.4 % wider than these.
  EXPECT_GE(least_used, 0.77f);
}

TEST(ShadowCasters, HoldMovingHeadsInSteadyTexels) {
  DERMIS_NEED_ASSETS(folder);
  expect_steady_texels(*folder / "makehuman" / "mh-african-man-young.glb");
  expect_steady_texels(*folder / "ict-facekit" / "ict-mean-animated.glb");
}

// A head that a pose carries away, towards a lamp or past it, is held as well.
TEST(ShadowCasters, HoldWhatWalksAway) {
  DERMIS_NEED_ASSETS(folder);
  const Warnings quiet;
  const std::shared_ptr<const AssetData> asset =
      measured(load_gltf(*folder / "makehuman" / "mh-african-man-young.glb"));
  const std::vector<Light> lights = lights_around(asset->casters);

  for (const auto& to_m : {glm::dvec3(0.2, 0, 0), glm::dvec3(-0.1, 0.3, 0.4), glm::dvec3(3, 0, 5)}) {
    const JointTransform away{.name = "root", .translation = {{to_m.x, to_m.y, to_m.z}}};
    const auto posed = api::posed_asset(*asset, RigPose{.joints = {away}});
    const std::vector<glm::vec3> vertices_m = posed_vertices(*asset, *posed);
    ASSERT_GT(glm::distance(vertices_m[0], vertices_of(*asset)[0]), 0.1f);
    for (const Light& light : lights) {
      const setup::Casters casters(*asset, posed.get(), {});
      const passes::ShadowFit fit = passes::fit_shadow(light, casters.bounds(), map_size);
      if (fit.shadow_from_world.size() == 1) Steady().add(fit, vertices_m);
    }
  }
}

// Without a pose the fit is that of the asset.
TEST(ShadowCasters, OfARestAreThoseOfTheAsset) {
  DERMIS_NEED_ASSETS(folder);
  const Warnings quiet;
  const std::shared_ptr<const AssetData> asset =
      measured(load_gltf(*folder / "makehuman" / "mh-african-man-young.glb"));
  const setup::Casters rest(*asset, nullptr, {});
  for (const Light& light : lights_around(asset->casters))
    EXPECT_EQ(passes::fit_shadow(light, rest.bounds(), map_size).texel,
              passes::fit_shadow(light, {asset->casters, asset->caster_corners_m}, map_size).texel);
}

}  // namespace
}  // namespace dermis::scene::test
