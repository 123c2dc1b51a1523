// SPDX-License-Identifier: MIT
#include "head/builtin_head/skull.h"

#include "base/core/parallel.h"

namespace dermis::builtin_head {
namespace {

const vec3 centre(0, -5, 0);

// Landmarks of the left half and the midline, mm: y from the line of the eyes, z from the middle of the head.
// Placed by the canon of proportions (eyes at half height, nose base half-way from brow to chin, mouth a
// third below) and by the breadths and lengths of tests/unit/builtin_head/anthropometry.h. Rounded by eye
// between them.
const std::vector<vec3> landmarks = {
    // midline, front, from the crown down; the nose is not part of this mass
    {0, 115, -10},
    {0, 109, 27},
    {0, 96, 53},
    {0, 80, 71},
    {0, 60, 84},
    {0, 40, 90.5f},
    {0, 25, 93.5f},
    {0, 16, 94.5f},
    {0, 4, 88},
    {0, -12, 87},
    {0, -28, 90},
    {0, -45, 94.5f},
    {0, -57, 96.5f},
    {0, -68, 96},
    {0, -78, 94},
    {0, -87, 91.5f},
    {0, -95, 93},
    {0, -103, 93.5f},
    {0, -111, 90},
    {0, -116, 81},
    {0, -119.5f, 63},
    {0, -122, 45},
    {0, -121, 20},
    {0, -105, -15},
    // midline, back
    {0, 111, -45},
    {0, 96, -71},
    {0, 70, -90},
    {0, 45, -98.5f},
    {0, 15, -100},
    {0, -15, -95},
    {0, -40, -84},
    {0, -60, -73},
    {0, -80, -55},
    // the vault
    {28, 109, 6},
    {30, 109, -22},
    {22, 106, -50},
    {26, 92, 52},
    {46, 93, 27},
    {55, 93, -12},
    {51, 92, -44},
    {28, 91, -68},
    {20, 79, 69},
    {43, 79, 54},
    {61.5f, 79, 15},
    {65, 79, -18},
    {57, 79, -55},
    {20, 60, 81},
    {39, 60, 71},
    {53, 60, 56},
    {64, 60, 34},
    {70, 60, 10},
    {73.5f, 60, -16},
    {70, 60, -46},
    {57, 60, -71},
    {30, 60, -88},
    {20, 37, 88.5f},
    {38, 36, 80},
    {50, 36, 67.5f},
    {60, 36, 50},
    {68, 36, 28},
    {74, 36, 0},
    {76.5f, 36, -22},
    {73, 36, -50},
    {57, 36, -77},
    {29, 36, -95},
    // brow and temple
    {56, 10, 67.5f},
    {62, 14, 52},
    {68, 13, 31},
    {73, 14, 5},
    {76, 13, -22},
    {73, 12, -50},
    {58, 12, -77},
    {30, 12, -95},
    // orbit (eyeballs are added later) and cheekbone
    {59, -2, 59},
    {66.5f, -3, 41},
    {71.5f, -4, 19},
    {73.5f, -5, -2},
    {74, -8, -25},
    {14, -14, 80.5f},
    {22, -14, 78.5f},
    {32, -14, 79.0f},
    {42, -14, 76.5f},
    {52, -14, 69.5f},
    {60.5f, -14, 58},
    {67.5f, -14, 39.5f},
    {71.5f, -14, 17},
    {71, -16, -10},
    {70, -18, -30},
    {62.5f, -20, -58},
    {46, -20, -78},
    {22, -20, -92},
    {20, -26, 82},
    {32, -26, 81.5f},
    {43, -26, 77.5f},
    {54, -26, 68.5f},
    {62, -26, 55},
    {68, -26, 36},
    {71, -27, 14},
    // cheek and ramus
    {15, -40, 89.5f},
    {25, -40, 86},
    {35, -40, 81},
    {45, -40, 74},
    {54, -40, 63},
    {61.5f, -40, 46},
    {66.5f, -40, 24},
    {68, -42, 0},
    {65, -44, -28},
    {53, -44, -55},
    {29, -44, -76},
    {15, -55, 94},
    {25, -55, 88.5f},
    {35, -55, 81},
    {45, -55, 71},
    {53, -55, 59.5f},
    {60, -55, 42},
    {64.5f, -55, 20},
    {65, -56, -2},
    {61, -58, -20},
    {54, -58, -36},
    // muzzle, jaw, chin
    {14, -68, 93.5f},
    {25, -68, 87.5f},
    {34, -68, 79.5f},
    {43, -68, 68.5f},
    {51, -68, 55},
    {57.5f, -68, 39},
    {62, -68, 19},
    {61, -70, 0},
    {55, -72, -16},
    {14, -82, 91},
    {25, -82, 85.5f},
    {34, -84, 75.5f},
    {43, -84, 61.5f},
    {51, -84, 43.5f},
    {57.5f, -82, 23},
    {56.5f, -80, 5},
    {48, -80, -8},
    {12, -98, 92},
    {22, -98, 85.5f},
    {31, -98, 73},
    {39, -97, 58},
    {46.5f, -95, 39},
    {51.5f, -91, 24},
    {11, -111, 87.5f},
    {22, -110, 77},
    {31, -107, 64},
    {39, -103, 48.5f},
    {46, -97.5f, 32},
    {51, -90.5f, 15},
    {50, -84, 2},
    // under the jaw
    {14, -118, 62},
    {24, -114.5f, 46},
    {32, -108, 27},
    {31, -101, 4},
    {18, -106, -6}};

// Allows the surface to miss a landmark in order to stay smooth; added to the diagonal of the interpolation
// (bending units).
constexpr double stiffness = 2e-5;

struct Interpolant {
  std::vector<vec3> directions;
  std::vector<double> weights;  // one per landmark, then 1, x, y, z
  double radius(const vec3& d) const {
    const std::size_t n = directions.size();
    double sum = weights[n] + weights[n + 1] * d.x + weights[n + 2] * d.y + weights[n + 3] * d.z;
    for (std::size_t i = 0; i < n; ++i) {
      const vec3 e = d - directions[i];
      const double r2 = static_cast<double>(glm::dot(e, e));
      sum += weights[i] * r2 * std::sqrt(r2);
    }
    return sum;
  }
};

void solve(std::vector<double>& a, std::vector<double>& b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(a[i * n + k]) > std::abs(a[pivot * n + k])) pivot = i;
    }
    if (pivot != k) {
      std::swap_ranges(a.begin() + static_cast<std::ptrdiff_t>(k * n),
                       a.begin() + static_cast<std::ptrdiff_t>((k + 1) * n),
                       a.begin() + static_cast<std::ptrdiff_t>(pivot * n));
      std::swap(b[k], b[pivot]);
    }

    for (std::size_t i = k + 1; i < n; ++i) {
      const double f = a[i * n + k] / a[k * n + k];
      if (f == 0) continue;
      for (std::size_t j = k; j < n; ++j) a[i * n + j] -= f * a[k * n + j];
      b[i] -= f * b[k];
    }
  }

  // Solves from the last row upwards.
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k * n + j] * b[j];
    b[k] /= a[k * n + k];
  }
}

Interpolant interpolate_landmarks() {
  Interpolant f;
  std::vector<double> radii;
  for (const vec3& p : landmarks) {
    for (const float side : {1.0f, -1.0f}) {
      if (p.x == 0 && side < 0) continue;
      const vec3 q = vec3(p.x * side, p.y, p.z) - centre;
      f.directions.push_back(glm::normalize(q));
      radii.push_back(static_cast<double>(glm::length(q)));
    }
  }

  // Fills the system: cubes of distances, stiffness on the diagonal, the linear part as a border.
  const std::size_t n = radii.size(), m = n + 4;
  std::vector<double> a(m * m, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      a[i * m + j] = std::pow(static_cast<double>(glm::distance(f.directions[i], f.directions[j])), 3);
    a[i * m + i] += stiffness;
    const std::array<double, 4> linear = {1.0, f.directions[i].x, f.directions[i].y, f.directions[i].z};
    for (std::size_t k = 0; k < 4; ++k) a[i * m + n + k] = a[(n + k) * m + i] = linear[k];
  }

  radii.resize(m, 0.0);
  solve(a, radii);
  f.weights = std::move(radii);
  return f;
}

// Cube faces +X -X +Y -Y +Z -Z; s and t are the two other axes in cyclic order, divided by the major one's
// magnitude.
vec3 cube_direction(int face, float s, float t) {
  const int axis = face / 2;
  vec3 d(0);
  d[axis] = face % 2 == 0 ? 1.0f : -1.0f;
  d[(axis + 1) % 3] = s;
  d[(axis + 2) % 3] = t;
  return glm::normalize(d);
}

// tan-warped face coordinates in -1..1: cells of about equal angle
float warp(float s) { return std::tan(s * 0.785398163f); }
float unwarp(float s) { return std::atan(s) / 0.785398163f; }

vec2 cubic_weights_low(float t) {
  return {t * (-0.5f + t * (1.0f - 0.5f * t)), 1.0f + t * t * (-2.5f + 1.5f * t)};
}
vec2 cubic_weights_high(float t) { return {t * (0.5f + t * (2.0f - 1.5f * t)), t * t * (-0.5f + 0.5f * t)}; }

}  // namespace

Skull::Skull() {
  const Interpolant f = interpolate_landmarks();
  for (auto& face : radii_) face.resize(static_cast<std::size_t>(stride * stride));
  parallel_for(6 * stride, [&](std::size_t row) {
    const int face = static_cast<int>(row) / stride, j = static_cast<int>(row) % stride;
    const auto at = [](int k) {
      return warp(2.0f * static_cast<float>(k - margin) / static_cast<float>(side) - 1.0f);
    };
    for (int i = 0; i < stride; ++i) {
      radii_[static_cast<std::size_t>(face)][static_cast<std::size_t>(j * stride + i)] =
          static_cast<float>(f.radius(cube_direction(face, at(i), at(j))));
    }
  });
}

float Skull::radius(const vec3& d) const {
  const vec3 m = glm::abs(d);
  const int axis = m.x >= m.y && m.x >= m.z ? 0 : (m.y >= m.z ? 1 : 2);
  const std::size_t face = static_cast<std::size_t>(2 * axis + (d[axis] < 0 ? 1 : 0));
  const float inverse = 1.0f / std::max(m[axis], 1e-6f);

  const float x = (unwarp(d[(axis + 1) % 3] * inverse) + 1.0f) * 0.5f * side + margin;
  const float y = (unwarp(d[(axis + 2) % 3] * inverse) + 1.0f) * 0.5f * side + margin;
  const int i = std::clamp(static_cast<int>(x), 1, stride - 3),
            j = std::clamp(static_cast<int>(y), 1, stride - 3);
  const float tx = x - static_cast<float>(i), ty = y - static_cast<float>(j);

  // Catmull-Rom weights, four along each axis.
  const vec2 xl = cubic_weights_low(tx), xh = cubic_weights_high(tx), yl = cubic_weights_low(ty),
             yh = cubic_weights_high(ty);
  const std::array<float, 4> wy = {yl.x, yl.y, yh.x, yh.y};

  float sum = 0;
  for (int k = 0; k < 4; ++k) {
    const float* row = &radii_[face][static_cast<std::size_t>((j - 1 + k) * stride + i - 1)];
    sum += wy[static_cast<std::size_t>(k)] * (xl.x * row[0] + xl.y * row[1] + xh.x * row[2] + xh.y * row[3]);
  }
  return sum;
}

float Skull::operator()(const vec3& p) const {
  const vec3 q = p - centre;
  const float length = glm::length(q);
  if (length < 5.0f) return -60.0f;
  // Rays meet the skin at up to 45 degrees (chin, jaw): 0.9 is the mean cosine.
  return 0.9f * (length - radius(q / length));
}

}  // namespace dermis::builtin_head
