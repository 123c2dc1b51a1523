// SPDX-License-Identifier: MIT
// Colour spaces of FLIP. White is D65; X, Y and Z are divided by those of white, so that white is (1, 1, 1).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace dermis::image::flip {

/// Linear light, 0 to 1.
struct Rgb {
  float r, g, b;
};

/// The linear opponent space of [ANAMOF20] sec. 4.1 without its scales: Y = 116 y - 16, Cx = 500 cx, Cz = 200
/// cz.
struct Opponent {
  float y, cx, cz;
};

struct Lab {
  float l, a, b;
};

using Matrix = std::array<std::array<float, 3>, 3>;

/// sRGB primaries and D65 to X, Y, Z, rows divided by their sums (the white point).
constexpr Matrix xyz_of_rgb = [] {
  constexpr std::array<std::array<double, 3>, 3> rows = {
      {{10135552, 8788810, 4435075}, {2613072, 8788810, 887015}, {1425312, 8788810, 70074185}}};
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      m[i][j] = static_cast<float>(rows[i][j] / (rows[i][0] + rows[i][1] + rows[i][2]));
  return m;
}();

/// Its inverse.
constexpr Matrix rgb_of_xyz = [] {
  const auto minor = [](std::size_t i, std::size_t j) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return static_cast<double>(xyz_of_rgb[i1][j1]) * xyz_of_rgb[i2][j2] -
           static_cast<double>(xyz_of_rgb[i1][j2]) * xyz_of_rgb[i2][j1];
  };
  double determinant = 0;
  for (std::size_t j = 0; j < 3; ++j) determinant += xyz_of_rgb[0][j] * minor(0, j);
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = static_cast<float>(minor(j, i) / determinant);
  return m;
}();

constexpr std::array<float, 3> multiply(const Matrix& m, float x, float y, float z) {
  std::array<float, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * x + m[i][1] * y + m[i][2] * z;
  return out;
}

constexpr Opponent opponent(const Rgb& linear) {
  const auto [x, y, z] = multiply(xyz_of_rgb, linear.r, linear.g, linear.b);
  return {y, x - y, y - z};
}

/// Returns CIELAB with a and b scaled by lightness (the Hunt effect: dark colours look less colourful).
/// [ANAMOF20] sec. 4.1.2 and 4.1.3.
inline Lab hunt_lab(const Rgb& linear) {
  constexpr float delta = 6.0f / 29.0f;
  const auto curve = [](float t) {
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0f / 29.0f;
  };
  const auto [x, y, z] = multiply(xyz_of_rgb, linear.r, linear.g, linear.b);
  const float fx = curve(x), fy = curve(y), fz = curve(z);
  const float l = 116 * fy - 16;
  return {l, 0.01f * l * 500 * (fx - fy), 0.01f * l * 200 * (fy - fz)};
}

/// Converts a filtered colour, clamped because it may lie outside what a screen shows.
inline Lab hunt_lab(const Opponent& filtered) {
  const auto [r, g, b] = multiply(rgb_of_xyz, filtered.y + filtered.cx, filtered.y, filtered.y - filtered.cz);
  return hunt_lab(Rgb{std::clamp(r, 0.0f, 1.0f), std::clamp(g, 0.0f, 1.0f), std::clamp(b, 0.0f, 1.0f)});
}

/// Returns HyAB, a distance for large differences: city block in lightness, Euclidean in colour. [ANAMOF20]
/// sec. 4.1.3.
inline float hyab(const Lab& p, const Lab& q) {
  return std::abs(p.l - q.l) + std::sqrt((p.a - q.a) * (p.a - q.a) + (p.b - q.b) * (p.b - q.b));
}

}  // namespace dermis::image::flip
