// SPDX-License-Identifier: MIT
#include "head/scene/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "dermis/error.h"
#include "head/scene/import/shapes.h"
#include "scan.h"

namespace dermis::scene {
namespace {

constexpr double degrees = 3.14159265358979323846 / 180;
const BoundingSphere head{{0.1f, 0.2f, -0.3f}, 0.15f};

glm::dvec3 eye_of(const Camera& c) { return glm::dvec3(c.world_from_camera[3]); }

TEST(BoundingSphere, KnownSets) {
  EXPECT_EQ(bounding_sphere({}).radius_m, 0);
  const std::vector<glm::vec3> one{{1, 2, 3}};
  EXPECT_EQ(bounding_sphere(one).centre_m, glm::vec3(1, 2, 3));
  const std::vector<glm::vec3> triangle{{-1, 0, 0}, {1, 0, 0}, {0, 2, 0}};  // box centre (0, 1, 0)
  EXPECT_EQ(bounding_sphere(triangle).centre_m, glm::vec3(0, 1, 0));
  EXPECT_NEAR(bounding_sphere(triangle).radius_m, std::sqrt(2.0), 1e-5);
}

TEST(BoundingSphere, HoldsAllAndTouchesOne) {
  std::mt19937 random(7);
  std::normal_distribution<float> normal;
  std::vector<glm::vec3> points;
  for (int i = 0; i < 500; ++i)
    points.emplace_back(normal(random), 2 * normal(random), 0.5f * normal(random));
  const BoundingSphere sphere = bounding_sphere(points);
  double farthest = 0;
  for (const glm::vec3& p : points)
    farthest = std::max(farthest, glm::distance(glm::dvec3(p), glm::dvec3(sphere.centre_m)));
  EXPECT_LE(farthest, sphere.radius_m);
  EXPECT_NEAR(farthest / sphere.radius_m, 1, 1e-5);
}

TEST(BoundingSphere, Scan) {
  DERMIS_NEED_SCAN(scan);
  EXPECT_NEAR(skin_bounds(*scan).sphere.radius_m, 0.293, 0.0005);
}

TEST(SkinSphere, LooksOnlyAtSkinIfThereIsAny) {
  AssetData scene = sphere(0.1, 8);
  Primitive far_away = scene.primitives[0];
  for (Vertex& v : far_away.vertices) v.position_m += glm::vec3(5, 0, 0);
  far_away.material = 1;
  scene.materials.push_back(test::material("cloth", false));
  scene.primitives.push_back(far_away);
  EXPECT_NEAR(skin_bounds(scene).sphere.radius_m, 0.1, 1e-5);
  scene.materials[0].skin = false;
  EXPECT_NEAR(skin_bounds(scene).sphere.radius_m, 2.6, 1e-4);
}

TEST(SkinBounds, AreABoxAndTheSphereAboutItsMiddle) {
  AssetData scene = sphere(0.1, 8);
  for (Vertex& v : scene.primitives[0].vertices) v.position_m += glm::vec3(1, 2, 3);
  const Bounds bounds = skin_bounds(scene);
  EXPECT_NEAR(glm::distance(bounds.low_m, glm::vec3(0.9f, 1.9f, 2.9f)), 0, 1e-5);
  EXPECT_NEAR(glm::distance(bounds.high_m, glm::vec3(1.1f, 2.1f, 3.1f)), 0, 1e-5);
  EXPECT_NEAR(glm::distance(bounds.sphere.centre_m, glm::vec3(1, 2, 3)), 0, 1e-5);
}

TEST(Framing, OutlineFillsTheSmallerSide) {
  for (const double aspect : {0.5, 1.0, 16.0 / 9})
    for (const double azimuth : {0.0, 40.0, -135.0}) {
      const Camera camera = framing_camera(head, aspect, azimuth, 15, 20);
      const glm::dvec3 to = eye_of(camera) - glm::dvec3(head.centre_m);
      // of the outline's half angle
      const double tangent = std::tan(std::asin(head.radius_m / glm::length(to)));
      EXPECT_NEAR(tangent / (std::tan(10 * degrees) * std::min(1.0, aspect)), 0.95, 1e-5);
      EXPECT_NEAR(std::atan2(to.x, to.z) / degrees, azimuth, 1e-3);
      EXPECT_NEAR(std::asin(to.y / glm::length(to)) / degrees, 15, 1e-3);
      // The centre projects to the middle of the picture.
      const glm::dvec4 seen =
          glm::inverse(glm::dmat4(camera.world_from_camera)) * glm::dvec4(glm::dvec3(head.centre_m), 1);
      EXPECT_NEAR(seen.x, 0, 1e-6);
      EXPECT_NEAR(seen.y, 0, 1e-6);
      EXPECT_LT(seen.z, 0);
      EXPECT_LT(camera.znear_m, glm::length(to) - head.radius_m);
    }
}

// How far the outline of a sphere reaches from the middle of the picture to each side, as a share of its
// half.
std::array<double, 4> reaches(const Camera& camera, const BoundingSphere& sphere, double aspect) {
  const glm::dvec3 at(glm::inverse(glm::dmat4(camera.world_from_camera)) *
                      glm::dvec4(glm::dvec3(sphere.centre_m), 1));
  std::array<double, 4> shares{};
  for (int axis = 0; axis < 2; ++axis) {
    const double half = std::tan(10 * degrees) * (axis == 0 ? aspect : 1);
    const double towards = std::atan2(at[axis], -at.z),
                 wide = std::asin(sphere.radius_m / std::hypot(at[axis], at.z));
    shares[2 * axis] = std::tan(towards + wide) / half;
    shares[2 * axis + 1] = -std::tan(towards - wide) / half;
  }
  return shares;
}

TEST(Framing, OfAGroupFillsThePictureAndHoldsAll) {
  const std::vector<std::vector<BoundingSphere>> groups = {
      {head, {{0.5f, 0.2f, -0.3f}, 0.15f}, {{1.0f, 0.2f, -0.3f}, 0.1f}, {{1.4f, 0.3f, -0.2f}, 0.2f}},
      {head, {{0.1f, 0.8f, 0.5f}, 0.3f}},
      {head, head}};
  for (const std::vector<BoundingSphere>& group : groups)
    for (const double aspect : {0.5, 1.0, 16.0 / 9})
      for (const double azimuth : {0.0, 40.0, -135.0}) {
        const Camera camera = group_camera(group, aspect, azimuth, 15, 20);
        double most = 0;
        for (const BoundingSphere& sphere : group)
          for (const double reach : reaches(camera, sphere, aspect)) most = std::max(most, reach);
        EXPECT_NEAR(most, 0.95, 1e-5) << group.size() << " " << aspect << " " << azimuth;
      }

  // Of one sphere it is the camera of that sphere.
  const Camera one = framing_camera(head, 1.5, 30, 10), group = group_camera({&head, 1}, 1.5, 30, 10);
  EXPECT_NEAR(glm::distance(eye_of(one), eye_of(group)), 0, 1e-6);
}

TEST(Framing, StaysRigidStraightAbove) {
  for (const double elevation : {0.0, 90.0, -90.0}) {
    const glm::dmat3 r(framing_camera(head, 1, 30, elevation).world_from_camera);
    EXPECT_NEAR(glm::determinant(r), 1, 1e-6);
    const glm::dmat3 product = glm::transpose(r) * r;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], i == j, 1e-6);
  }
  EXPECT_NEAR(framing_camera(head, 1, 0, 0).world_from_camera[1].y, 1, 1e-6) << "up is +Y from the front";
}

TEST(Framing, RefusesNonsense) {
  EXPECT_THROW(framing_camera({{}, 0}, 1), InputError);
  EXPECT_THROW(framing_camera(head, 0), InputError);
  EXPECT_THROW(group_camera({}, 1), InputError);
  EXPECT_THROW(group_camera({&head, 1}, 0), InputError);
  EXPECT_THROW(group_camera({&head, 1}, 1, 0, 0, 180), InputError);
  EXPECT_THROW(framing_camera(head, 1, 0, 0, 180), InputError);
  EXPECT_THROW(distance_camera(head, 0), InputError);
  EXPECT_THROW(distance_camera(head, std::nan("")), InputError);
  EXPECT_THROW(head_row_offsets(0, 1), InputError);
  EXPECT_THROW(light_rig(head, -1), InputError);
}

TEST(PaperTest, DistanceInRadiiAndRowOfHeads) {
  const Camera camera = distance_camera(head, 4.5);
  const glm::dvec3 expected = glm::dvec3(head.centre_m) + glm::dvec3(0, 0, 4.5 * head.radius_m);
  EXPECT_LT(glm::distance(eye_of(camera), expected), 1e-6);
  EXPECT_NEAR(camera.fov_y_rad / degrees, 20, 1e-4);
  for (const int heads : {1, 2, 3, 4, 5}) {
    const std::vector<glm::vec3> offsets = head_row_offsets(heads, 0.15);
    ASSERT_EQ(offsets.size(), static_cast<std::size_t>(heads));
    EXPECT_EQ(offsets[static_cast<std::size_t>(heads / 2)], glm::vec3(0));
    for (std::size_t i = 1; i < offsets.size(); ++i) EXPECT_NEAR(offsets[i].x - offsets[i - 1].x, 0.24, 1e-6);
  }
}

TEST(LightRig, DirectionsAndIrradianceAtTheCentre) {
  struct Expected {
    double azimuth, elevation;
    glm::dvec3 irradiance;
  };

  const std::vector<Expected> table{{45, 35, {3, 2.88, 2.7}},
                                    {-60, 10, {0.68, 0.736, 0.8}},
                                    {160, 25, {2, 2, 2}},
                                    {195, 20, {1, 1, 1}},
                                    {375, 20, {1, 1, 1}}};

  const std::vector<Light> lights = light_rig(head, 5);
  ASSERT_EQ(lights.size(), table.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    EXPECT_EQ(light.type, LightType::spot);
    const glm::dvec3 to = glm::dvec3(light.position_m) - glm::dvec3(head.centre_m);
    EXPECT_NEAR(glm::length(to), 4 * head.radius_m, 1e-5);
    EXPECT_LT(glm::distance(glm::normalize(to), head_direction(table[i].azimuth, table[i].elevation)), 1e-5)
        << i;
    EXPECT_LT(glm::distance(glm::normalize(to), -glm::dvec3(light.direction)), 1e-5);
    EXPECT_LT(glm::distance(glm::dvec3(light.colour) / glm::dot(to, to), table[i].irradiance), 1e-4) << i;
    EXPECT_NEAR(light.inner_cone_rad, std::asin(0.25), 1e-5);
    EXPECT_GT(light.outer_cone_rad, light.inner_cone_rad);
  }

  EXPECT_GT(lights[0].position_m.x, head.centre_m.x) << "the key stands at the head's left, +X";
  EXPECT_TRUE(light_rig(head, 0).empty());
  EXPECT_EQ(light_rig(head, 2).size(), 2u);
}

TEST(LightRig, LampsOfOnesOwn) {
  const std::vector<Lamp> lamps{{"side", 90, 10, glm::dvec3(2.5)}, {"below", -30, -90, glm::dvec3(1, 0, 0)}};
  const std::vector<Light> lights = light_rig(head, lamps);
  ASSERT_EQ(lights.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const glm::dvec3 to = glm::dvec3(lights[i].position_m) - glm::dvec3(head.centre_m);
    EXPECT_EQ(lights[i].name, lamps[i].name);
    EXPECT_LT(
        glm::distance(to, 4.0 * head.radius_m * head_direction(lamps[i].azimuth_deg, lamps[i].elevation_deg)),
        1e-5);
    EXPECT_LT(glm::distance(glm::dvec3(lights[i].colour) / glm::dot(to, to), lamps[i].irradiance), 1e-4);
  }
  EXPECT_NEAR(lights[0].position_m.x - head.centre_m.x, 4 * head.radius_m * std::cos(10 * degrees), 1e-5)
      << "90 degrees is the left";
  EXPECT_TRUE(light_rig(head, std::vector<Lamp>{}).empty());
  EXPECT_THROW(light_rig(BoundingSphere{}, lamps), InputError);
}

TEST(LightRig, ConesHoldTheWholeRow) {
  const std::vector<glm::vec3> offsets = head_row_offsets(5, head.radius_m);
  for (const Light& light : light_rig(head, 4, offsets)) {
    for (const glm::vec3& offset : offsets) {
      const glm::dvec3 to = glm::dvec3(head.centre_m) + glm::dvec3(offset) - glm::dvec3(light.position_m);
      const double half =
          std::acos(std::min(1.0, glm::dot(glm::normalize(to), glm::dvec3(light.direction)))) +
          std::asin(std::min(1.0, head.radius_m / glm::length(to)));
      EXPECT_LE(std::min(half, 83 * degrees), light.inner_cone_rad + 1e-4) << light.name;
    }
    EXPECT_LT(light.outer_cone_rad, 1.5708f);
  }
}

}  // namespace
}  // namespace dermis::scene
