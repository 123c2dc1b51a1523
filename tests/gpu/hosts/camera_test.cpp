// SPDX-License-Identifier: MIT
// The camera of a host, by its matrices, draws what the same camera by the settings draws, in parts too.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "dermis/renderer.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"

namespace dermis::tests {
namespace {

constexpr int side = 64;
constexpr double fov_deg = 24, near_m = 0.02;

RenderSettings settings_for(int width, int height) {
  RenderSettings s = unoptimised(small_settings("texture-space", side, 128));
  s.output.width = width, s.output.height = height;
  s.output.bloom = 0;
  s.output.exposure_ev = 0;
  return s;
}

// The view from (0, 0, 0.5) along -z, and the part of its picture between two corners, 0 to 1 from the upper
// left one. Forward depth, y down: another convention than ours.
CameraMatrices matrices_of(double left, double top, double right, double bottom) {
  const double half = std::tan(fov_deg / 2 * 3.14159265358979 / 180);
  const auto x = [&](double at) { return half * (2 * at - 1); };
  const auto y = [&](double at) { return half * (1 - 2 * at); };
  const double x0 = x(left), x1 = x(right), y0 = y(bottom), y1 = y(top), far_m = 10;
  CameraMatrices m;
  m.camera_from_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -0.5, 1};
  m.clip_from_camera = {2 / (x1 - x0),
                        0,
                        0,
                        0,  // x
                        0,
                        -2 / (y1 - y0),
                        0,
                        0,  // y
                        (x1 + x0) / (x1 - x0),
                        -(y1 + y0) / (y1 - y0),
                        -far_m / (far_m - near_m),
                        -1,  // z
                        0,
                        0,
                        -near_m * far_m / (far_m - near_m),
                        0};
  return m;
}

// Rounding may move the border of a triangle over the middle of a pixel, here and there.
void expect_alike(const std::vector<float>& a, const std::vector<float>& b) {
  ASSERT_EQ(a.size(), b.size());
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > 1.0f / 255) ++differing;
  EXPECT_LE(differing, a.size() / 200);
  EXPECT_GT(*std::max_element(a.begin(), a.end()), 0.1f) << "nothing is lit";
}

TEST(Cameras, ByMatricesDrawWhatLookingAtAPointDraws) {
  const Scene scene = sphere(0.0713);
  RenderSettings s = settings_for(side, side);
  s.camera.eye_m = {0, 0, 0.5};
  s.camera.target_m = {0, 0, 0};
  s.camera.fov_deg = fov_deg;
  const Picture looked_at = renderer().render(scene, s);

  s.camera = {.matrices = matrices_of(0, 0, 1, 1)};
  expect_alike(renderer().render(scene, s).linear_rgba, looked_at.linear_rgba);
}

// Four pictures off the axis are the quarters of the whole.
TEST(Cameras, OffTheAxisDrawPartsOfAPicture) {
  const Scene scene = sphere(0.0713);
  RenderSettings s = settings_for(side, side);
  s.camera.matrices = matrices_of(0, 0, 1, 1);
  const Picture whole = renderer().render(scene, s);

  std::vector<float> joined(whole.linear_rgba.size());
  constexpr int half = side / 2;
  s = settings_for(half, half);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column) {
      s.camera.matrices = matrices_of(0.5 * column, 0.5 * row, 0.5 * (column + 1), 0.5 * (row + 1));
      const Picture part = renderer().render(scene, s);
      for (int y = 0; y < half; ++y) {
        const auto from = part.linear_rgba.begin() + std::ptrdiff_t{4} * y * half;
        const auto to = joined.begin() + std::ptrdiff_t{4} * ((row * half + y) * side + column * half);
        std::copy(from, from + std::ptrdiff_t{4} * half, to);
      }
    }
  expect_alike(joined, whole.linear_rgba);
}

}  // namespace
}  // namespace dermis::tests
