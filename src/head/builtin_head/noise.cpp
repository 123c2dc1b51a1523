// SPDX-License-Identifier: MIT
#include "head/builtin_head/noise.h"

#include <algorithm>
#include <cmath>

namespace dermis::builtin_head {
namespace {

std::uint32_t mix_bits(std::uint32_t h) {
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  return h ^ (h >> 16);
}

int floor_int(float x) {
  const int i = static_cast<int>(x);
  return i - (x < static_cast<float>(i) ? 1 : 0);
}

// The twelve edges of a cube as gradients (Perlin's improved noise), four of them twice. A table, because
// branches on a hash cannot be predicted.
constexpr float edges[16][3] = {{1, 1, 0},  {-1, 1, 0},  {1, -1, 0}, {-1, -1, 0}, {1, 0, 1},  {-1, 0, 1},
                                {1, 0, -1}, {-1, 0, -1}, {0, 1, 1},  {0, -1, 1},  {0, 1, -1}, {0, -1, -1},
                                {1, 1, 0},  {-1, 1, 0},  {0, -1, 1}, {0, -1, -1}};
const float* slope_of(std::uint32_t h) { return edges[h >> 28]; }

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }
float mix(float a, float b, float t) { return a + t * (b - a); }

}  // namespace

std::uint32_t lattice_hash(int x, int y, int z, std::uint32_t seed) {
  return mix_bits(static_cast<std::uint32_t>(x) * 0x8da6b343u ^ static_cast<std::uint32_t>(y) * 0xd8163841u ^
                  static_cast<std::uint32_t>(z) * 0xcb1ab31fu ^ seed * 0x9e3779b9u);
}

float gradient_noise(const glm::vec3& p, std::uint32_t seed) { return NoiseWalk(seed)(p); }

float NoiseWalk::operator()(const glm::vec3& p) {
  const int i = floor_int(p.x), j = floor_int(p.y), k = floor_int(p.z);
  if (!filled_ || i != i_ || j != j_ || k != k_) {
    // Corners with the lower x first, then those with the lower y: halves are mixed.
    for (std::size_t n = 0; n < 8; ++n) {
      const int corner = static_cast<int>(n);
      const float* slope =
          slope_of(lattice_hash(i + (corner >> 2), j + ((corner >> 1) & 1), k + (corner & 1), seed_));
      slope_x_[n] = slope[0], slope_y_[n] = slope[1], slope_z_[n] = slope[2];
    }
    i_ = i, j_ = j, k_ = k;
    filled_ = true;
  }

  const float x = p.x - static_cast<float>(i), y = p.y - static_cast<float>(j),
              z = p.z - static_cast<float>(k);
  const float u = fade(x), v = fade(y), w = fade(z);
  const Corners dx = {x, x, x, x, x - 1, x - 1, x - 1, x - 1}, dy = {y, y, y - 1, y - 1, y, y, y - 1, y - 1},
                dz = {z, z - 1, z, z - 1, z, z - 1, z, z - 1};
  Corners rise;
  for (std::size_t n = 0; n < 8; ++n)
    rise[n] = slope_x_[n] * dx[n] + slope_y_[n] * dy[n] + slope_z_[n] * dz[n];
  for (std::size_t n = 0; n < 4; ++n) rise[n] = mix(rise[n], rise[n + 4], u);
  return mix(mix(rise[0], rise[2], v), mix(rise[1], rise[3], v), w);
}

float layered_noise(const glm::vec3& p, int octaves, std::uint32_t seed) {
  float sum = 0, strength = 1, scale = 1;
  for (int o = 0; o < octaves; ++o) {
    sum += strength * gradient_noise(p * scale, seed + static_cast<std::uint32_t>(o));
    strength *= 0.5f;
    scale *= 2.03f;
  }
  return sum;
}

Cell cells(const glm::vec3& p, std::uint32_t seed) { return CellWalk(seed)(p); }

Cell CellWalk::operator()(const glm::vec3& p, const glm::vec3& along) {
  // The two nearest cells along each axis.
  const int i = floor_int(p.x - 0.5f), j = floor_int(p.y - 0.5f), k = floor_int(p.z - 0.5f);
  if (!filled_ || i != i_ || j != j_ || k != k_) {
    for (int n = 0; n < 8; ++n) {
      const int a = i + (n & 1), b = j + ((n >> 1) & 1), c = k + (n >> 2);
      const std::uint32_t h = lattice_hash(a, b, c, seed_);
      const auto jitter = [&](int shift) {
        return 0.2f + 0.6f * static_cast<float>((h >> shift) & 1023u) * (1.0f / 1023.0f);
      };
      const auto self = static_cast<std::size_t>(n);
      hashes_[self] = h;
      x_[self] = static_cast<float>(a) + jitter(0);
      y_[self] = static_cast<float>(b) + jitter(10);
      z_[self] = static_cast<float>(c) + jitter(20);
    }
    i_ = i, j_ = j, k_ = k;
    filled_ = true;
  }

  Corners squared;
  for (std::size_t n = 0; n < 8; ++n) {
    const float dx = x_[n] - p.x, dy = y_[n] - p.y, dz = z_[n] - p.z;
    const float slanted = dx * along.x + dy * along.y + dz * along.z;
    squared[n] = std::max(dx * dx + dy * dy + dz * dz - slanted * slanted, 0.0f);
  }

  float first2 = 1e9f, second2 = 1e9f;
  std::size_t nearest = 0;
  for (std::size_t n = 0; n < 8; ++n) {
    const float d2 = squared[n];
    nearest = d2 < first2 ? n : nearest;
    second2 = std::min(second2, std::max(first2, d2));
    first2 = std::min(first2, d2);
  }
  return {std::sqrt(first2), std::sqrt(second2), mix_bits(hashes_[nearest])};
}

}  // namespace dermis::builtin_head
