// SPDX-License-Identifier: MIT
#include "builtin_head/skull.h"

#include "core/parallel.h"

namespace dermis::builtin_head {
namespace {

const vec3 centre(0, -5, 0);

// Landmarks of the left half and the midline, mm: y from the line of the eyes, z from the middle of the head.
// Placed by the canon of proportions (eyes at half height, nose base half-way from brow to chin, mouth a
// third below) and rounded anthropometric means: head 230 high, 152 wide, 195 long, face 140 wide at the
// cheekbones, jaw 104 wide.
const std::vector<vec3> landmarks = {
    // midline, front, from the crown down; the nose is not part of this mass
    {0, 115, -8},
    {0, 109, 30},
    {0, 96, 56},
    {0, 80, 73},
    {0, 60, 85},
    {0, 40, 91},
    {0, 25, 94},
    {0, 16, 95},
    {0, 4, 88},
    {0, -12, 87},
    {0, -28, 90},
    {0, -45, 94.5f},
    {0, -57, 97},
    {0, -68, 96.5f},
    {0, -78, 94},
    {0, -87, 91},
    {0, -95, 93},
    {0, -103, 94.5f},
    {0, -111, 90},
    {0, -115.5f, 80},
    {0, -117, 60},
    {0, -115, 40},
    {0, -110, 15},
    {0, -95, -20},
    // midline, back
    {0, 111, -45},
    {0, 96, -70},
    {0, 70, -89},
    {0, 45, -97},
    {0, 15, -99},
    {0, -15, -93},
    {0, -40, -82},
    {0, -60, -70},
    {0, -80, -50},
    // the vault
    {28, 109, 8},
    {30, 109, -20},
    {22, 106, -48},
    {26, 92, 54},
    {45, 93, 28},
    {54, 93, -10},
    {50, 92, -42},
    {28, 91, -67},
    {20, 79, 71},
    {43, 79, 55},
    {60.5f, 79, 16},
    {64, 79, -16},
    {56, 79, -54},
    {20, 60, 82},
    {39, 60, 72},
    {53, 60, 56},
    {62.5f, 60, 34},
    {69, 60, 10},
    {72.5f, 60, -16},
    {68, 60, -47},
    {55, 60, -72},
    {29, 60, -87},
    {20, 37, 89},
    {37, 36, 80},
    {49, 35, 67},
    {58, 35, 48},
    {65, 35, 28},
    {72, 35, 0},
    {76, 35, -22},
    {72, 35, -52},
    {55, 35, -78},
    {28, 35, -94},
    // brow and temple
    {55, 9, 67},
    {60, 16, 48},
    {65, 14, 27},
    {71, 15, 0},
    {75, 13, -22},
    {72, 12, -52},
    {56, 12, -78},
    {30, 12, -94},
    // orbit (eyeballs are added later) and cheekbone
    {57, -2, 58},
    {64, -3, 40},
    {70, -4, 18},
    {72, -5, -2},
    {73, -8, -25},
    {14, -14, 80.5f},
    {22, -14, 78.5f},
    {32, -14, 79.0f},
    {42, -14, 76.5f},
    {52, -14, 68.5f},
    {60, -14, 56},
    {67, -14, 38},
    {70.5f, -14, 15},
    {70, -16, -10},
    {69, -18, -30},
    {61, -20, -58},
    {45, -20, -78},
    {22, -20, -90},
    {20, -26, 82},
    {32, -26, 81},
    {43, -26, 76.5f},
    {54, -26, 66},
    {62, -26, 50},
    {67, -24, 33},
    // cheek and ramus
    {15, -40, 89},
    {25, -40, 85},
    {35, -40, 79},
    {45, -40, 69.5f},
    {54, -40, 55},
    {61, -40, 37},
    {65, -40, 15},
    {65, -42, -8},
    {61, -44, -30},
    {51, -44, -55},
    {28, -44, -74},
    {15, -55, 94},
    {25, -55, 87},
    {35, -55, 77.5f},
    {45, -55, 65},
    {53, -55, 49},
    {59, -55, 30},
    {61, -56, 10},
    {58, -58, -10},
    {52, -58, -30},
    // muzzle, jaw, chin
    {14, -68, 93.5f},
    {25, -68, 86},
    {34, -68, 76},
    {43, -68, 63},
    {50, -68, 46},
    {55, -70, 26},
    {57, -70, 10},
    {52, -72, -8},
    {14, -82, 90.5f},
    {25, -82, 84},
    {34, -84, 73},
    {42, -84, 57},
    {48, -84, 38},
    {52, -82, 20},
    {49, -84, 3},
    {12, -98, 92},
    {22, -98, 84.5f},
    {31, -98, 71},
    {38, -97, 54},
    {44, -94, 37},
    {11, -111, 87},
    {22, -109, 76},
    {31, -105.5f, 62},
    {39, -100, 46},
    {45, -93, 30},
    {49, -86, 14},
    {46, -80, -2},
    // under the jaw
    {14, -116, 62},
    {24, -111, 45},
    {31, -104, 25},
    {30, -98, 2},
    {18, -103, -6}};

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
