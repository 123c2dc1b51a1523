// SPDX-License-Identifier: MIT
#include "head/scene/surface/displacement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "head/scene/import/shapes.h"
#include "scan.h"

namespace dermis::scene {
namespace {

using std::numbers::pi;

/// value: 0..1 at texel centres, u and v in 0..1.
image::Image8 heights_of(int width, int height, const std::function<double(double, double)>& value) {
  image::Image8 h{width, height, {}};
  h.rgba.assign(static_cast<std::size_t>(width * height * 4), 255);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        h.at(x, y)[c] =
            static_cast<std::uint8_t>(std::lround(255 * value((x + 0.5) / width, (y + 0.5) / height)));
  return h;
}

glm::dvec3 normal_at(const image::Image8& n, int x, int y) {
  return glm::normalize(glm::dvec3(n.at(x, y)[0], n.at(x, y)[1], n.at(x, y)[2]) / 127.5 - 1.0);
}

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::min(1.0, glm::dot(a, b))) * 180 / pi;
}

TEST(Displacement, WavesAgainstTheirDerivative) {
  DisplacementSettings s;
  s.displacement_mm = 2;
  s.mm_per_uv = {60, 90};

  const double ku = 2 * pi * 3, kv = 2 * pi * 2;
  const auto wave = [&](double u, double v) { return 0.5 + 0.3 * std::sin(ku * u) + 0.2 * std::cos(kv * v); };
  const image::Image8 n = displaced_normals(heights_of(256, 192, wave), s);
  ASSERT_EQ(n.width, 256);
  ASSERT_EQ(n.height, 192);

  for (int y = 0; y < n.height; ++y)
    for (int x = 0; x < n.width; ++x) {
      const double u = (x + 0.5) / n.width, v = (y + 0.5) / n.height;
      // mm per mm
      const double dh_du = 2 * 0.3 * ku * std::cos(ku * u) / 60,
                   dh_dv = -2 * 0.2 * kv * std::sin(kv * v) / 90;
      ASSERT_LT(degrees_between(normal_at(n, x, y), glm::normalize(glm::dvec3(-dh_du, dh_dv, 1))), 2.5)
          << x << ' ' << y;
      ASSERT_EQ(n.at(x, y)[3], 255);
    }
}

TEST(Displacement, ARampOfStairsComesOutEven) {
  // 24 steps over 256 texels: raw differences would be 0 or 12 degrees, the truth is 1.7 degrees.
  DisplacementSettings s;
  s.displacement_mm = 3;
  s.mm_per_uv = {9.6, 9.6};
  s.wrap_u = AssetWrap::clamp;

  const image::Image8 n =
      displaced_normals(heights_of(256, 8, [](double u, double) { return 24 * u / 255; }), s);
  const glm::dvec3 expected = glm::normalize(glm::dvec3(-24 * 3 / 255.0 / 9.6, 0, 1));

  double mean = 0, worst = 0;
  for (int x = 16; x < 240; ++x) {
    const double error = degrees_between(normal_at(n, x, 4), expected);
    worst = std::max(worst, error);
    mean += normal_at(n, x, 4).x / 224;
  }

  EXPECT_NEAR(mean, expected.x, 0.1 * std::abs(expected.x));
  EXPECT_LT(worst, 5);

  EXPECT_NEAR(height_smoothing_texels(3.0 / 255, 0.0375), 1.44, 0.02);
  EXPECT_EQ(height_smoothing_texels(0, 0.1), 0.7);
  EXPECT_EQ(height_smoothing_texels(-100.0 / 255, 0.1), 2);
}

// A gentle wave: steps of 8 bits show as contour lines, however they are smoothed.
TEST(Displacement, HeightsOf16BitsHaveNoSteps) {
  DisplacementSettings s;
  s.displacement_mm = 3;
  s.mm_per_uv = {600, 600};
  const auto wave = [](double u, double) { return 0.5 + 0.08 * std::sin(6 * 2 * pi * u); };
  image::Image8 heights = heights_of(1024, 4, wave);
  const auto worst = [&] {
    const image::Image8 n = displaced_normals(heights, s);
    double found = 0;
    for (int x = 0; x < n.width; ++x) {
      const double slope = 3 * 0.08 * 6 * 2 * pi * std::cos(6 * 2 * pi * (x + 0.5) / 1024) / 600;
      found = std::max(found, degrees_between(normal_at(n, x, 2), glm::normalize(glm::dvec3(-slope, 0, 1))));
    }
    return found;
  };
  EXPECT_GT(worst(), 0.5);
  for (int i = 0; i < 1024 * 4 * 4; ++i)
    heights.rgba16.push_back(
        static_cast<std::uint16_t>(std::lround(65535 * wave((i / 4 % 1024 + 0.5) / 1024, 0))));
  EXPECT_LT(worst(), 0.4) << "half a step of the normal's 8 bits";
}

TEST(Displacement, FlatHeightsKeepTheBase) {
  image::Image8 base{4, 4, std::vector<std::uint8_t>(64, 255)};
  for (int i = 0; i < 16; ++i) {
    const glm::dvec3 n = glm::normalize(glm::dvec3(0.1 * (i % 4) - 0.15, 0.2 * (i / 4) - 0.3, 1));
    for (int c = 0; c < 3; ++c)
      base.at(i % 4, i / 4)[c] = static_cast<std::uint8_t>(std::lround((n[c] + 1) * 127.5));
  }

  const image::Image8 grey = heights_of(4, 4, [](double, double) { return 0.5; });
  DisplacementSettings s;
  s.displacement_mm = 5;
  const image::Image8 same = displaced_normals(grey, s, &base);
  for (int i = 0; i < 16; ++i) {
    const glm::dvec3 n(
        glm::dvec3(base.at(i % 4, i / 4)[0], base.at(i % 4, i / 4)[1], base.at(i % 4, i / 4)[2]) / 127.5 -
        1.0);
    EXPECT_LT(degrees_between(normal_at(same, i % 4, i / 4), glm::normalize(n)), 0.6);
  }

  s.base_scale = 0;
  const image::Image8 flat = displaced_normals(grey, s, &base);
  for (std::size_t i = 0; i < flat.rgba.size(); i += 4) EXPECT_EQ(flat.rgba[i] + flat.rgba[i + 1], 256);
}

// A base as fine as the heights leaves nothing to take away.
TEST(Displacement, SlopesAddToTheBase) {
  const auto tilt = [](double u, double) { return 0.5 + 0.4 * std::sin(2 * pi * u); };
  DisplacementSettings s;
  s.displacement_mm = 1;
  s.mm_per_uv = {10, 10};
  const image::Image8 heights = heights_of(128, 128, tilt);
  const image::Image8 alone = displaced_normals(heights, s);
  const image::Image8 twice = displaced_normals(heights, s, &alone);
  const glm::dvec3 once_n = normal_at(alone, 0, 64), twice_n = normal_at(twice, 0, 64);
  EXPECT_NEAR(twice_n.x / twice_n.z, 2 * once_n.x / once_n.z, 0.02);
}

TEST(Displacement, TakesOnlyWhatIsFinerThanTheBase) {
  DisplacementSettings s;
  s.displacement_mm = 3;
  s.mm_per_uv = {40, 40};
  const image::Image8 base{16, 16, [] {
                             std::vector<std::uint8_t> flat;
                             for (int i = 0; i < 256; ++i) flat.insert(flat.end(), {128, 128, 255, 255});
                             return flat;
                           }()};

  const auto strength = [&](double waves) {
    const image::Image8 n = displaced_normals(
        heights_of(256, 256, [&](double u, double) { return 0.5 + 0.4 * std::sin(2 * pi * waves * u); }), s,
        &base);
    double part = 0;  // of the wave in the slopes
    for (int x = 0; x < 256; ++x)
      part -=
          normal_at(n, x, 128).x / normal_at(n, x, 128).z * std::cos(2 * pi * waves * (x + 0.5) / 256) / 128;

    // Divide by the wave's own slope, mm per mm.
    return part / (3 * 0.4 * 2 * pi * waves / 40);
  };

  EXPECT_LT(strength(1), 0.09) << "a slow wave is the base map's affair";
  EXPECT_GT(strength(16), 0.8) << "one wave per texel of the base is beyond it";
}

TEST(Displacement, SizesAndEdges) {
  DisplacementSettings s;
  s.displacement_mm = 1;
  const auto one = heights_of(1, 1, [](double, double) { return 1.0; });
  for (const AssetWrap wrap : {AssetWrap::repeat, AssetWrap::clamp, AssetWrap::mirror}) {
    s.wrap_u = s.wrap_v = wrap;
    const image::Image8 n = displaced_normals(one, s);
    EXPECT_EQ(n.rgba, (std::vector<std::uint8_t>{128, 128, 255, 255}));
  }
  const image::Image8 wide = displaced_normals(heights_of(5000, 2, [](double u, double) { return u; }), s);
  EXPECT_EQ(wide.width, 4096);
  EXPECT_EQ(wide.height, 2);
  const image::Image8 base{7, 9, std::vector<std::uint8_t>(7 * 9 * 4, 200)};
  const image::Image8 larger = displaced_normals(one, s, &base);
  EXPECT_EQ(larger.width, 7);
  EXPECT_EQ(larger.height, 9);
}

TEST(Displacement, MeanMillimetresOfPlanes) {
  const auto mesh_of = [](const AssetData& scene) { return skin_meshes(scene).at(0); };
  const glm::dvec2 square = mean_mm_per_uv(mesh_of(plane(0.05, glm::dmat2(0.5, 0, 0, 1))), 1000);
  EXPECT_NEAR(square.x, 100, 1e-3);
  EXPECT_NEAR(square.y, 50, 1e-3);
  const glm::dvec2 sheared = mean_mm_per_uv(mesh_of(plane(0.05, glm::dmat2(0.5, 0, 0.5, 0.5))), 1000);
  EXPECT_NEAR(sheared.x, 100, 1e-3);
  EXPECT_NEAR(sheared.y, 100, 1e-3) << "square to dP/du, not along dP/dv";
  DERMIS_NEED_SCAN(scan);
  const glm::dvec2 head = mean_mm_per_uv(mesh_of(*scan), 1000);
  EXPECT_GT(std::min(head.x, head.y), 100);
  EXPECT_LT(std::max(head.x, head.y), 2000);
}

}  // namespace
}  // namespace dermis::scene
