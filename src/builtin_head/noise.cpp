// SPDX-License-Identifier: MIT
#include "builtin_head/noise.h"

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
float slope(std::uint32_t h, float x, float y, float z) {
  const float* e = edges[h >> 28];
  return e[0] * x + e[1] * y + e[2] * z;
}

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }
float mix(float a, float b, float t) { return a + t * (b - a); }

}  // namespace

std::uint32_t lattice_hash(int x, int y, int z, std::uint32_t seed) {
  return mix_bits(static_cast<std::uint32_t>(x) * 0x8da6b343u ^ static_cast<std::uint32_t>(y) * 0xd8163841u ^
                  static_cast<std::uint32_t>(z) * 0xcb1ab31fu ^ seed * 0x9e3779b9u);
}

float gradient_noise(const glm::vec3& p, std::uint32_t seed) {
  const int i = floor_int(p.x), j = floor_int(p.y), k = floor_int(p.z);
  const float x = p.x - static_cast<float>(i), y = p.y - static_cast<float>(j),
              z = p.z - static_cast<float>(k);
  const float u = fade(x), v = fade(y), w = fade(z);
  const auto corner = [&](int a, int b, int c) {
    return slope(lattice_hash(i + a, j + b, k + c, seed), x - static_cast<float>(a),
                 y - static_cast<float>(b), z - static_cast<float>(c));
  };
  const float near =
      mix(mix(corner(0, 0, 0), corner(1, 0, 0), u), mix(corner(0, 1, 0), corner(1, 1, 0), u), v);
  const float far =
      mix(mix(corner(0, 0, 1), corner(1, 0, 1), u), mix(corner(0, 1, 1), corner(1, 1, 1), u), v);
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

Cell cells(const glm::vec3& p, std::uint32_t seed) {
  // The two nearest cells along each axis.
  const int i = floor_int(p.x - 0.5f), j = floor_int(p.y - 0.5f), k = floor_int(p.z - 0.5f);
  float first2 = 1e9f, second2 = 1e9f;
  Cell cell;

  for (int n = 0; n < 8; ++n) {
    const int a = i + (n & 1), b = j + ((n >> 1) & 1), c = k + (n >> 2);
    const std::uint32_t h = lattice_hash(a, b, c, seed);
    const auto jitter = [&](int shift) {
      return 0.2f + 0.6f * static_cast<float>((h >> shift) & 1023u) * (1.0f / 1023.0f);
    };
    const glm::vec3 d(static_cast<float>(a) + jitter(0) - p.x, static_cast<float>(b) + jitter(10) - p.y,
                      static_cast<float>(c) + jitter(20) - p.z);
    const float d2 = glm::dot(d, d);

    if (d2 < first2) {
      second2 = first2;
      first2 = d2;
      cell.id = mix_bits(h);
    } else if (d2 < second2) {
      second2 = d2;
    }
  }

  cell.nearest = std::sqrt(first2);
  cell.second = std::sqrt(second2);
  return cell;
}

}  // namespace dermis::builtin_head
