// SPDX-License-Identifier: MIT
#include "builtin_head/noise.h"

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
float rise(const float* e, float x, float y, float z) { return e[0] * x + e[1] * y + e[2] * z; }

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
    for (int n = 0; n < 8; ++n)
      slopes_[static_cast<std::size_t>(n)] =
          slope_of(lattice_hash(i + (n & 1), j + ((n >> 1) & 1), k + (n >> 2), seed_));
    i_ = i, j_ = j, k_ = k;
    filled_ = true;
  }

  const float x = p.x - static_cast<float>(i), y = p.y - static_cast<float>(j),
              z = p.z - static_cast<float>(k);
  const float u = fade(x), v = fade(y), w = fade(z);
  const float near = mix(mix(rise(slopes_[0], x, y, z), rise(slopes_[1], x - 1, y, z), u),
                         mix(rise(slopes_[2], x, y - 1, z), rise(slopes_[3], x - 1, y - 1, z), u), v);
  const float far = mix(mix(rise(slopes_[4], x, y, z - 1), rise(slopes_[5], x - 1, y, z - 1), u),
                        mix(rise(slopes_[6], x, y - 1, z - 1), rise(slopes_[7], x - 1, y - 1, z - 1), u), v);
  return mix(near, far, w);
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
      points_[self] = {static_cast<float>(a) + jitter(0), static_cast<float>(b) + jitter(10),
                       static_cast<float>(c) + jitter(20)};
    }
    i_ = i, j_ = j, k_ = k;
    filled_ = true;
  }

  float first2 = 1e9f, second2 = 1e9f;
  std::size_t nearest = 0;
  for (std::size_t n = 0; n < 8; ++n) {
    const glm::vec3 d = points_[n] - p;
    const float slanted = glm::dot(d, along);
    const float d2 = std::max(glm::dot(d, d) - slanted * slanted, 0.0f);
    nearest = d2 < first2 ? n : nearest;
    second2 = std::min(second2, std::max(first2, d2));
    first2 = std::min(first2, d2);
  }
  return {std::sqrt(first2), std::sqrt(second2), mix_bits(hashes_[nearest])};
}

}  // namespace dermis::builtin_head
