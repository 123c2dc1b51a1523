// SPDX-License-Identifier: MIT
#include "head/scene/surface/turned.h"

#include <algorithm>
#include <cmath>

#include "head/scene/surface/weld.h"

namespace dermis::scene {
namespace {

// Real heads have a dozen; a hostile file must not cost the square of its size.
constexpr std::size_t most_at_a_place = 64;
// One degree less than 105 - 90: the eye is not equally far from all vertices.
constexpr double cosine_14_degrees = 0.97029573;

bool turned(const SkinMesh& mesh, std::size_t triangle) {
  const auto corner = [&](std::size_t k) -> const Vertex& {
    return mesh.vertices[mesh.indices[3 * triangle + k]];
  };
  const glm::dvec3 a(corner(0).position_m),
      face = glm::cross(glm::dvec3(corner(1).position_m) - a, glm::dvec3(corner(2).position_m) - a);
  if (face == glm::dvec3(0)) return false;  // no pixel shows it
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 n(corner(k).normal);
    if (!(glm::dot(face, n) > cosine_14_degrees * glm::length(face) * glm::length(n))) return true;
  }
  return false;
}

template <class Counts>
std::vector<std::uint32_t> neighbours(const SkinMesh& mesh, const Counts& counts) {
  const std::size_t triangles = mesh.triangle_chart.size();
  const std::vector<std::uint32_t> place = weld_positions(mesh.vertices);
  std::vector<std::vector<std::uint32_t>> at_place(mesh.vertices.size());
  for (std::size_t t = 0; t < triangles; ++t)
    if (mesh.triangle_chart[t] != no_chart && counts(t))
      for (std::size_t k = 0; k < 3; ++k)
        at_place[place[mesh.indices[3 * t + k]]].push_back(static_cast<std::uint32_t>(t));

  // Packs: offsets of the list of each triangle, then the lists.
  std::vector<std::uint32_t> packed(triangles + 1), found;
  for (std::size_t t = 0; t < triangles; ++t) {
    packed[t] = static_cast<std::uint32_t>(packed.size());
    found.clear();

    for (std::size_t k = 0; k < 3; ++k) {
      const std::vector<std::uint32_t>& here = at_place[place[mesh.indices[3 * t + k]]];
      if (here.size() > most_at_a_place) {
        found = {always_kept};
        break;
      }
      for (const std::uint32_t other : here)
        if (other != t) found.push_back(other);
    }

    std::sort(found.begin(), found.end());
    packed.insert(packed.end(), found.begin(), std::unique(found.begin(), found.end()));
  }

  packed[triangles] = static_cast<std::uint32_t>(packed.size());
  return packed;
}

}  // namespace

std::vector<std::uint32_t> turned_neighbours(const SkinMesh& mesh) {
  return neighbours(mesh, [&](std::size_t t) { return turned(mesh, t); });
}

std::vector<std::uint32_t> touching_neighbours(const SkinMesh& mesh) {
  return neighbours(mesh, [](std::size_t) { return true; });
}

}  // namespace dermis::scene
