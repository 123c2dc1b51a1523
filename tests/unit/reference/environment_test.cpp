// SPDX-License-Identifier: MIT
// Pictures of the surroundings as light: directions are drawn as they claim, and what is lit by them is
// known.
#include "truth/reference/environment_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "head/scene/import/shapes.h"
#include "truth/reference/checkpoint.h"
#include "unit/reference/scenes.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

environment::Environment painted(int width, int height,
                                 const std::function<glm::dvec3(const glm::dvec3&)>& radiance) {
  environment::Environment e{.name = "painted",
                             .radiance = {.width = width, .height = height, .channels = 3, .values = {}}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 rgb = radiance(environment::direction_of((x + 0.5) / width, (y + 0.5) / height));
      for (int c = 0; c < 3; ++c) e.radiance.values.push_back(static_cast<float>(rgb[c]));
    }
  return e;
}

std::shared_ptr<const EnvironmentSampler> uniform(double radiance) {
  return std::make_shared<const EnvironmentSampler>(
      painted(8, 4, [&](const glm::dvec3&) { return glm::dvec3(radiance); }), 1, 0);
}

environment::Environment two_lamps(int width, int height) {
  return painted(width, height, [](const glm::dvec3& d) {
    return glm::dvec3(0.1, 0.2, 0.1) +
           (glm::dot(d, glm::normalize(glm::dvec3(1, 1, 1))) > 0.9 ? glm::dvec3(9) : glm::dvec3(0)) +
           (d.y < -0.95 ? glm::dvec3(0, 3, 0) : glm::dvec3(0));
  });
}

// The mean of f / density over directions that are drawn is the integral of f, for any f: here 1, which finds
// holes and wrong solid angles, and the radiance times a cosine, against a sum over fine steps.
TEST(EnvironmentSampler, DirectionsAreDrawnAsTheyClaim) {
  const glm::dvec3 n = glm::normalize(glm::dvec3(0.2, -0.5, 0.8));
  for (const auto& [width, height] : {std::pair(1, 1), {7, 5}, {64, 32}, {1500, 700}})
    for (const double rotation_deg : {0.0, 77.0}) {
      const EnvironmentSampler sky(two_lamps(width, height), 2, rotation_deg);
      double ones = 0;
      glm::dvec3 drawn(0), summed(0);
      constexpr int count = 60'000, rows = 350;

      for (int i = 0; i < count; ++i) {
        Random random = random_of(1, static_cast<std::uint32_t>(i), 0);
        const glm::dvec3 d = sky.draw(random);
        EXPECT_NEAR(glm::length(d), 1, 1e-9);
        const double density = sky.density(d);
        ASSERT_GT(density, 0);
        ones += 1 / density / count;
        drawn += sky.radiance(d) * (std::max(0.0, glm::dot(n, d)) / density / count);
      }

      for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 2 * rows; ++x) {
          const glm::dvec3 d = environment::direction_of((x + 0.5) / (2 * rows), (y + 0.5) / rows);
          summed += sky.radiance(d) * (std::max(0.0, glm::dot(n, d)) * std::sin(pi * (y + 0.5) / rows) * pi *
                                       pi / (rows * rows));
        }

      EXPECT_NEAR(ones / (4 * pi), 1, 0.03) << width << " x " << height;
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(drawn[c] / summed[c], 1, 0.02) << width << " x " << height << ", channel " << c;
    }
}

TEST(EnvironmentSampler, TurnTowardsTheLeft) {
  const auto lamp_at = [](const glm::dvec3& to) {
    return painted(128, 64, [=](const glm::dvec3& d) { return glm::dvec3(glm::dot(d, to) > 0.95 ? 1 : 0); });
  };
  const EnvironmentSampler turned(lamp_at({0, 0, 1}), 1, 90);  // from the front
  EXPECT_GT(turned.radiance({1, 0, 0}).x, 0.99);
  EXPECT_EQ(turned.radiance({0, 0, 1}).x, 0);
}

TEST(EnvironmentSampler, BlackOnesAreBlack) {
  const scene::AssetData ball = scene::sphere(0.05, 16);
  Job job = tests::furnace(ball, 8);
  job.setup.environment = uniform(0);
  const image::ImageF picture = tests::rendered(Tracer(ball, job), 8).picture();
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    if (i % 4 < 3) { EXPECT_EQ(picture.values[i], 0); }
}

/// The mean over pixels that are wholly covered, of all channels.
double mean_of(const Film& film) {
  const image::ImageF picture = film.picture();
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < picture.values.size(); i += 4) {
    if (picture.values[i + 3] < 1) continue;
    sum += (double{picture.values[i]} + double{picture.values[i + 1]} + double{picture.values[i + 2]}) / 3;
    ++count;
  }
  return sum / count;
}

/// A plane of skin at the bottom of a well of four white walls, seen from above.
scene::AssetData well() {
  scene::AssetData made = scene::plane(0.2, glm::dmat2(1), {}, 1);
  made.materials.push_back({.name = "wall", .double_sided = true});

  scene::Primitive p{.name = "walls", .material = 1};
  constexpr float half = 0.012f, high = 0.03f;
  for (int i = 0; i < 8; ++i) {
    scene::Vertex v;
    v.position_m = {(i & 3) == 1 || (i & 3) == 2 ? half : -half, (i & 2) ? half : -half,
                    i & 4 ? high : -1e-4f};
    p.vertices.push_back(v);
  }

  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    p.indices.insert(p.indices.end(), {i, j, j + 4, i, j + 4, i + 4});
  }

  // Normals as the faces have them: outwards; the camera looks in from within.
  for (scene::Vertex& v : p.vertices) v.normal = glm::normalize(glm::vec3(v.position_m.x, v.position_m.y, 0));
  made.primitives.push_back(std::move(p));
  return made;
}

// White surroundings, white bodies: whatever hides the sky sends on as much as it hides, over any number of
// bounces.
TEST(EnvironmentSampler, FurnaceIsWhiteInAWell) {
  scene::AssetData scene = well();
  for (scene::Material& material : scene.materials) material.base_colour = {0.5f, 0.5f, 0.5f, 1};
  for (const bool specular : {false, true}) {
    Job job = tests::furnace(scene, 12);
    job.setup.ambient = 0;
    job.setup.environment = uniform(1);
    job.setup.camera = tests::camera_from_above(0.01, {0, 0, 0.02f});
    job.setup.specular = specular;
    EXPECT_NEAR(mean_of(tests::rendered(Tracer(scene, job), 512)), 1, 0.01) << "specular " << specular;
    job.setup.white_albedo = false;  // grey walls and skin darken each other
    EXPECT_LT(mean_of(tests::rendered(Tracer(scene, job), 64)), 0.45) << "half of it in the open";
  }
}

// A lamp that covers little of the sky is a directional light of its radiance times its solid angle.
TEST(EnvironmentSampler, ASmallLampIsADirectionalLight) {
  const glm::dvec3 to_lamp = glm::normalize(glm::dvec3(0.6, 0.3, 0.9));
  constexpr double half_angle = 0.05, radiance = 400;
  const double irradiance = radiance * 2 * pi * (1 - std::cos(half_angle));
  const scene::AssetData ball = scene::sphere(0.05, 32);
  Job job = tests::furnace(ball, 16);
  job.setup.ambient = 0;
  Job lit = job;
  const auto disc = painted(1024, 512, [&](const glm::dvec3& d) {
    return glm::dvec3(glm::dot(d, to_lamp) > std::cos(half_angle) ? radiance : 0);
  });
  job.setup.environment = std::make_shared<const EnvironmentSampler>(disc, 1, 0);
  lit.setup.lights.push_back(
      {.name = "sun", .colour = glm::vec3(static_cast<float>(irradiance)), .direction = -glm::vec3(to_lamp)});
  const double ours = mean_of(tests::rendered(Tracer(ball, job), 256)),
               wanted = mean_of(tests::rendered(Tracer(ball, lit), 256));
  EXPECT_NEAR(ours / wanted, 1, 0.015);
}

// Metal that is nearly a mirror shows the picture in the mirrored direction.
TEST(EnvironmentSampler, ShowInAMirror) {
  scene::AssetData scene = scene::plane(0.2, glm::dmat2(1), {}, 1);
  scene.materials.front().skin = false;
  scene.materials.front().metallic = 1, scene.materials.front().roughness = 0.05f;
  Job job = tests::furnace(scene, 4);
  job.setup.ambient = 0;
  job.setup.camera = tests::camera_from_above(0.01, {0, 0, 0.5f});
  job.setup.environment = std::make_shared<const EnvironmentSampler>(
      painted(256, 128, [](const glm::dvec3& d) { return glm::dvec3(1 + d.z, 1 - d.z, d.z > 0.9 ? 1 : 0); }),
      1, 0);
  const image::ImageF picture = tests::rendered(Tracer(scene, job), 4096).picture();
  EXPECT_NEAR(picture.at(2, 2)[0], 2, 0.02);
  EXPECT_NEAR(picture.at(2, 2)[1], 0, 0.02);
  EXPECT_NEAR(picture.at(2, 2)[2], 1, 0.02);
}

TEST(EnvironmentSampler, ACheckpointKnowsThem) {
  const scene::AssetData ball = scene::sphere(0.05, 8);
  Job job = tests::furnace(ball, 4);
  const std::uint64_t without = fingerprint(ball, job, 1);
  job.setup.environment = uniform(1);
  const std::uint64_t one = fingerprint(ball, job, 1);
  job.setup.environment = uniform(2);
  EXPECT_NE(without, one);
  EXPECT_NE(one, fingerprint(ball, job, 1));
}

}  // namespace
}  // namespace dermis::reference
