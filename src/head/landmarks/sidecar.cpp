// SPDX-License-Identifier: MIT
#include "head/landmarks/sidecar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dermis::landmarks {
namespace {

constexpr std::uint64_t most_meshes = std::numeric_limits<int>::max();
constexpr std::uint64_t most_vertices = std::numeric_limits<std::uint32_t>::max();

int mesh_number(const json::Value& object) {
  return static_cast<int>(object.at("mesh").count(0, most_meshes));
}

LandmarkPlace read_place(const json::Value& point) {
  point.only_keys({"mesh", "triangle", "weights"});
  LandmarkPlace place{.mesh = mesh_number(point)};
  const json::Value triangle = point.at("triangle");
  triangle.array_size(3, 3);
  double sum = 0;
  point.at("weights").array_size(3, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    place.vertices[k] = static_cast<std::uint32_t>(triangle.element(k).count(0, most_vertices));
    place.weights[k] = point.at("weights").element(k).number(0, 1);
    sum += place.weights[k];
  }
  if (std::abs(sum - 1) > 1e-6) point.fail("weights must sum to 1, got {}", sum);
  // A file has rounded them.
  for (double& weight : place.weights) weight /= sum;
  return place;
}

}  // namespace

Sidecar read_sidecar(const json::Value& root) {
  root.only_keys({"schema", "about", "meshes", "points"});
  root.at("schema").count(1, 1);
  if (const auto about = root.find("about")) about->text();

  Sidecar sidecar;
  const json::Value meshes = root.at("meshes");
  for (std::size_t i = 0; i < meshes.array_size(1, 1000); ++i) {
    const json::Value mesh = meshes.element(i);
    mesh.only_keys({"mesh", "vertices", "triangles"});
    sidecar.meshes.push_back({.mesh = mesh_number(mesh),
                              .vertices = mesh.at("vertices").count(1),
                              .triangles = mesh.at("triangles").count(1)});
  }

  const json::Value points = root.at("points");
  points.array_size(Landmarks::count, Landmarks::count);
  for (std::size_t i = 0; i < Landmarks::count; ++i) {
    const json::Value point = points.element(i);
    sidecar.places[i] = read_place(point);
    if (std::ranges::find(sidecar.meshes, sidecar.places[i].mesh, &MeshSize::mesh) == sidecar.meshes.end())
      point.fail("mesh {} is not in 'meshes'", sidecar.places[i].mesh);
  }
  return sidecar;
}

}  // namespace dermis::landmarks
