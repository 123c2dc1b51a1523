// SPDX-License-Identifier: MIT
#include "environment/occlusion.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "dermis/cancelled.h"
#include "environment/environment.h"
#include "environment/prepare/sky_rays.h"
#include "head/scene/import/shapes.h"
#include "rays/ray_scene.h"
#include "support/log_lines.h"

namespace dermis::environment {
namespace {

// A floor of skin in the xy plane, 1 m wide, with a wall of height h along x = -0.5 m (or none): what the
// floor sees is known.
scene::AssetData floor_with_wall(double height_m) {
  scene::AssetData made = scene::plane(1);
  if (height_m <= 0) return made;
  made.materials.push_back({.name = "wall"});
  scene::Primitive wall{.name = "wall", .material = 1};
  for (const glm::vec3 p :
       {glm::vec3(-0.5f, -50, 0), glm::vec3(-0.5f, 50, 0), glm::vec3(-0.5f, 50, static_cast<float>(height_m)),
        glm::vec3(-0.5f, -50, static_cast<float>(height_m))})
    wall.vertices.push_back({.position_m = p});
  wall.indices = {0, 1, 2, 0, 2, 3};
  made.primitives.push_back(wall);
  return made;
}

const float* texel(const Occlusion& o, int x, int y) {
  return o.values.data() +
         (static_cast<std::size_t>(y) * static_cast<std::size_t>(o.side) + static_cast<std::size_t>(x)) * 4;
}

TEST(Occlusion, BesideAWallIsTheFormFactor) {
  for (const double height : {0.1, 0.5}) {
    const scene::AssetData scene = floor_with_wall(height);
    const Occlusion o = bake_occlusion(scene, scene::skin_meshes(scene)[0], {.side = 64, .rays = 256});
    for (int x = 2; x < 62; x += 5) {
      const double d = (x + 0.5) / 64, exact = 1 - 0.5 * (1 - d / std::sqrt(d * d + height * height));
      double mean = 0;
      for (int y = 20; y < 44; ++y) mean += texel(o, x, y)[3] / 24;
      EXPECT_NEAR(mean, exact, 0.01) << d;
    }
    EXPECT_GT(texel(o, 1, 32)[0], 0.1) << "it opens away from the wall";
    EXPECT_NEAR(texel(o, 1, 32)[1], 0, 0.05);
  }
}

TEST(Occlusion, NothingInTheWayIsOpen) {
  const scene::AssetData flat = floor_with_wall(0), round = scene::sphere(0.1, 24);
  for (const scene::AssetData* scene : {&flat, &round}) {
    const Occlusion o = bake_occlusion(*scene, scene::skin_meshes(*scene)[0], {.side = 96, .rays = 32});
    for (std::size_t i = 0; i < o.values.size(); i += 4) {
      EXPECT_EQ(o.values[i + 3], 1.0f);
      EXPECT_LT(glm::length(glm::vec3(o.values[i], o.values[i + 1], o.values[i + 2])), 1e-5f);
    }
    SkyHarmonics white{};
    white[0] = glm::dvec3(std::sqrt(4 * std::numbers::pi));
    const std::vector<float> light = sky_light(o, white, white).direct;
    for (std::size_t i = 0; i < light.size(); i += 4) EXPECT_NEAR(light[i], std::numbers::pi, 2e-3);
  }
}

// A sky that is brighter towards +x, or -x, or above: what is left of it beside the wall, against a sum over
// fine steps.
TEST(Occlusion, SkyLightKnowsWhereTheWallStands) {
  const scene::AssetData scene = floor_with_wall(0.5);
  const Occlusion o = bake_occlusion(scene, scene::skin_meshes(scene)[0], {.side = 64, .rays = 256});

  const auto radiance = [](const glm::dvec3& d) { return glm::dvec3(1 + d.x, 1 - d.x, 0.5 + d.z * d.z); };
  constexpr int rows = 128;
  image::ImageF picture{.width = 2 * rows, .height = rows, .channels = 3, .values = {}};
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < 2 * rows; ++x) {
      const glm::dvec3 rgb = radiance(direction_of((x + 0.5) / (2 * rows), (y + 0.5) / rows));
      for (int c = 0; c < 3; ++c) picture.values.push_back(static_cast<float>(rgb[c]));
    }

  const std::vector<float> light = sky_light(o, sky_of(picture), {}).direct;
  for (int x = 2; x < 62; x += 5) {
    const double distance = (x + 0.5) / 64;
    glm::dvec3 exact(0), mean(0);

    // Sum over the sky above the floor that the wall, 0.5 m high, does not hide.
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < 2 * rows; ++j) {
        const double v = (i + 0.5) / rows;
        const glm::dvec3 d = direction_of((j + 0.5) / (2 * rows), v);
        if (d.z <= 0 || (d.x < 0 && distance * d.z < -d.x * 0.5)) continue;
        exact += radiance(d) *
                 (d.z * std::sin(std::numbers::pi * v) * std::numbers::pi * std::numbers::pi / (rows * rows));
      }

    for (int y = 20; y < 44; ++y)
      for (int c = 0; c < 3; ++c)
        mean[c] += double{light[static_cast<std::size_t>((y * 64 + x) * 4 + c)]} / 24;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(mean[c], exact[c], 0.02 * std::numbers::pi) << distance << ", channel " << c;
  }
}

/// Two strips of skin that meet at a right angle along the y axis: a floor and a wall, each 1 m wide, on one
/// half of the unwrap each.
scene::AssetData corner() {
  scene::AssetData made = scene::plane(1);
  scene::Primitive& p = made.primitives.front();
  p.vertices.clear(), p.indices.clear();
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 4; ++i) {
      const float across = i & 1 ? 1.0f : 0.0f, along = i & 2 ? 50.0f : -50.0f;
      scene::Vertex v;
      v.position_m = k == 0 ? glm::vec3(across, along, 0) : glm::vec3(0, along, across);
      v.normal = k == 0 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
      v.uv0 = {0.5f * static_cast<float>(k) + 0.45f * across + 0.02f, i & 2 ? 0.95f : 0.05f};
      p.vertices.push_back(v);
    }
  p.indices = {0, 1, 3, 0, 3, 2, 4, 7, 5, 4, 6, 7};
  return made;
}

// White skin in white surroundings is white, whatever hides what; and in a corner the floor at a distance d
// sees the wall, whose share of the sky is known.
TEST(Occlusion, WhatHidesTheSkySendsItOn) {
  const scene::AssetData scene = corner();
  const Occlusion o = bake_occlusion(scene, scene::skin_meshes(scene)[0], {.side = 64, .rays = 256});

  SkyHarmonics white{};
  white[0] = glm::dvec3(std::sqrt(4 * std::numbers::pi));
  const SkyLight light = sky_light(o, white, white);
  for (std::size_t i = 0; i < light.direct.size(); i += 4)
    EXPECT_NEAR(light.direct[i] + light.bounced[i], std::numbers::pi, 0.01);

  // 0.25 m from the wall: of the height z of the wall a strip dz has the form factor below, and sees the
  // floor as the floor sees it.
  const auto share = [](double distance) {
    return 1 - 0.5 * (1 - distance / std::sqrt(distance * distance + 1));
  };
  constexpr double d = 0.25;
  double hidden = 0, open = 0;
  for (int i = 0; i < 1000; ++i) {
    const double z = (i + 0.5) / 1000, factor = 0.5 * d * z / std::pow(d * d + z * z, 1.5) / 1000;
    hidden += factor;
    open += factor * share(z);
  }

  // Find the texel 0.25 m from the wall: 1 m of the floor is 0.45 of the unwrap, from 0.02 on.
  const int x = static_cast<int>((0.02 + 0.45 * d) * 64);
  const float* at = &light.bounced[static_cast<std::size_t>((32 * 64 + x) * 4)];
  EXPECT_NEAR(at[3], open / hidden, 0.03);
  EXPECT_NEAR(at[0], hidden * std::numbers::pi, 0.1);
}

TEST(Occlusion, IsKeptOnDiskAndCheckedWhenRead) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "dermis_occlusion_cache";
  std::filesystem::remove_all(folder);
  const scene::AssetData scene = floor_with_wall(0.3);
  const scene::SkinMesh mesh = scene::skin_meshes(scene)[0];
  const OcclusionSettings settings{.side = 32, .rays = 16};
  const Occlusion first = cached_occlusion(scene, mesh, folder, settings);
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  ASSERT_EQ(files.size(), 1u);
  const auto file_number = [&] {
    struct stat status {};
    EXPECT_EQ(::stat(files[0].c_str(), &status), 0);
    return status.st_ino;
  };
  const auto written = file_number();
  EXPECT_EQ(cached_occlusion(scene, mesh, folder, settings).values, first.values);
  EXPECT_EQ(cached_occlusion(scene, mesh, folder, settings).transfer, first.transfer);
  EXPECT_EQ(file_number(), written) << "it was written anew";
  EXPECT_EQ(cached_occlusion(scene, mesh, {}, settings).values, first.values) << "the same without a cache";

  // A changed share of the sky is a number like any other: the checksum alone knows.
  tests::LogLines said;
  const auto size = std::filesystem::file_size(files[0]);
  std::fstream(files[0], std::ios::binary | std::ios::in | std::ios::out).seekp(1000).put('\x21');
  EXPECT_EQ(cached_occlusion(scene, mesh, folder, settings).values, first.values);
  std::filesystem::resize_file(files[0], size / 2);
  EXPECT_EQ(cached_occlusion(scene, mesh, folder, settings).values, first.values);
  EXPECT_EQ(std::filesystem::file_size(files[0]), size);
  std::ofstream(files[0], std::ios::binary) << std::string(size, '\x7f');
  EXPECT_EQ(cached_occlusion(scene, mesh, folder, settings).values, first.values);
  EXPECT_EQ(said.all.size(), 3u);

  const scene::AssetData other = floor_with_wall(0.2);
  EXPECT_NE(cached_occlusion(other, scene::skin_meshes(other)[0], folder, settings).values, first.values);
  std::filesystem::remove_all(folder);
}

// Sixteen directions side by side have the harmonics of each alone.
TEST(Occlusion, LanesAreTheHarmonics) {
  DirectionLanes lanes;
  std::array<glm::dvec3, ray_lanes> directions;
  for (std::size_t j = 0; j < ray_lanes; ++j) {
    directions[j] =
        direction_of(0.03 + 0.061 * static_cast<double>(j), 0.02 + 0.064 * static_cast<double>(j));
    lanes.x[j] = static_cast<float>(directions[j].x);
    lanes.y[j] = static_cast<float>(directions[j].y);
    lanes.z[j] = static_cast<float>(directions[j].z);
  }
  HarmonicLanes found;
  harmonics_of(lanes, found);
  for (std::size_t j = 0; j < ray_lanes; ++j) {
    const Harmonics exact = harmonics(directions[j]);
    for (std::size_t k = 0; k < harmonic_terms; ++k) EXPECT_NEAR(found[k][j], exact[k], 3e-6) << k;
  }
}

TEST(Occlusion, ManyMeshesShareTheTexels) {
  EXPECT_EQ(occlusion_side(1), 512);
  EXPECT_EQ(occlusion_side(4), 512);
  EXPECT_EQ(occlusion_side(5), 256);
  EXPECT_EQ(occlusion_side(65), 64);
  EXPECT_EQ(occlusion_side(100'000), 64);
}

TEST(Occlusion, ABakeIsWatchedAndStopped) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "dermis_stopped_bake";
  std::filesystem::remove_all(folder);
  const scene::AssetData scene = floor_with_wall(0.3);
  const scene::SkinMesh mesh = scene::skin_meshes(scene)[0];
  const OcclusionSettings settings{.side = 32, .rays = 8};
  std::vector<double> shares;
  Hooks hooks{.progress = [&](const WorkProgress& work) {
    shares.push_back(work.share);
    return true;
  }};
  {
    const HookScope scope(hooks);
    const Occlusion watched = bake_occlusion(scene, mesh, settings);
    EXPECT_EQ(watched.transfer, bake_occlusion(scene, mesh, settings).transfer);
  }
  ASSERT_EQ(shares.size() % 2, 0u);
  const auto first = shares.begin(), second = first + static_cast<std::ptrdiff_t>(shares.size() / 2);
  EXPECT_TRUE(std::is_sorted(first, second));
  EXPECT_EQ(*(second - 1), 1);
  // Both passes are counted row by row, and what comes before and between them.
  EXPECT_GT(second - first, 64);
  for (auto share = first + 1; share != second; ++share) EXPECT_LE(*share - *(share - 1), 0.051);

  for (const double last : {0.0, 0.5, 0.9}) {
    hooks.progress = [&](const WorkProgress& work) { return work.share <= last; };
    const HookScope scope(hooks);
    EXPECT_THROW(cached_occlusion(scene, mesh, folder, settings), Cancelled);
    EXPECT_FALSE(std::filesystem::exists(folder)) << "something was written";
  }
}

// Embree asks while it builds, so that a scene of millions of triangles need not be sorted to the end.
TEST(RayScene, IsEndedWhileItSortsTriangles) {
  const scene::AssetData scene = scene::sphere(1, 60);
  int told = 0;
  {
    const HookScope scope(Hooks{.progress = [&](const WorkProgress& work) {
      EXPECT_EQ(work.what, "sorting the triangles");
      return ++told > 0;
    }});
    const rays::RayScene whole(scene);
    EXPECT_EQ(told, 6) << "one primitive, five trees";
  }

  for (int ended = 1; ended <= told; ++ended) {
    int now = 0;
    const HookScope scope(Hooks{.progress = [&](const WorkProgress&) { return ++now < ended; }});
    EXPECT_THROW(rays::RayScene{scene}, Cancelled);
  }
}

}  // namespace
}  // namespace dermis::environment
