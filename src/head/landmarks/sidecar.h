// SPDX-License-Identifier: MIT
/// Files of landmarks, as dermis/landmarks.h describes them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/json/document.h"
#include "dermis/landmarks.h"

namespace dermis::landmarks {

/// Size of a mesh, so that landmarks of another head are told apart.
struct MeshSize {
  int mesh = 0;
  std::size_t vertices = 0;  ///< those that a triangle uses
  std::size_t triangles = 0;
};

struct Sidecar {
  std::vector<MeshSize> meshes;
  std::array<LandmarkPlace, Landmarks::count> places;
};

inline constexpr std::uint64_t most_bytes = 1 << 20;
inline constexpr json::Limits sidecar_limits{.depth = 6, .values = 10'000};

/// Throws InputError: a key or a value that such a file cannot have; weights that do not sum to 1; a point of
/// a mesh that is not listed.
Sidecar read_sidecar(const json::Value& root);

}  // namespace dermis::landmarks
