// SPDX-License-Identifier: MIT
// Noise in space, so that the seam of the unwrap does not show. Integer hashes only: the same bits
// everywhere.
#pragma once

#include <array>
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

/// Eight numbers, one for each corner of a lattice cell: loops over them become vector instructions.
using Corners = std::array<float, 8>;

/// gradient_noise() of one seed, to the same bits, that keeps the hashes of the last lattice cell:
/// neighbouring texels mostly share it.
class NoiseWalk {
 public:
  explicit NoiseWalk(std::uint32_t seed) : seed_(seed) {}
  float operator()(const glm::vec3& p);

 private:
  std::uint32_t seed_;
  bool filled_ = false;
  int i_ = 0, j_ = 0, k_ = 0;
  Corners slope_x_{}, slope_y_{}, slope_z_{};
};

/// cells() of one seed, likewise.
class CellWalk {
 public:
  explicit CellWalk(std::uint32_t seed) : seed_(seed) {}
  /// `along`: cells are drawn out in this direction, by 1 / sqrt(1 - |along|^2); its length is under 0.9.
  Cell operator()(const glm::vec3& p, const glm::vec3& along = glm::vec3(0));

 private:
  std::uint32_t seed_;
  bool filled_ = false;
  int i_ = 0, j_ = 0, k_ = 0;
  Corners x_{}, y_{}, z_{};
  std::array<std::uint32_t, 8> hashes_{};
};

}  // namespace dermis::builtin_head
