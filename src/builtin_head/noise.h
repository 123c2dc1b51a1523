// SPDX-License-Identifier: MIT
// Noise in space, so that the seam of the unwrap does not show. Integer hashes only: the same bits
// everywhere.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace dermis::builtin_head {

/// Returns well mixed 32 bits for a lattice point.
std::uint32_t lattice_hash(int x, int y, int z, std::uint32_t seed);
/// Returns 0..1 from the upper bits.
inline float unit(std::uint32_t h) { return static_cast<float>(h >> 8) * (1.0f / 16777216.0f); }

/// Returns gradient noise, about -1..1, mean 0, without period; features about one unit wide.
float gradient_noise(const glm::vec3& p, std::uint32_t seed);
/// Returns `octaves` of gradient noise, each half as large and half as strong; about -1..1.
float layered_noise(const glm::vec3& p, int octaves, std::uint32_t seed);

struct Cell {
  float nearest = 0;     ///< distance to the nearest feature point, in cells
  float second = 0;      ///< to the second nearest
  std::uint32_t id = 0;  ///< hash of the nearest one
};
/// Returns cellular noise with one point per cell, jittered within the middle 60 % so that eight cells
/// suffice.
Cell cells(const glm::vec3& p, std::uint32_t seed);

}  // namespace dermis::builtin_head
