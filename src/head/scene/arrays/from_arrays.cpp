// SPDX-License-Identifier: MIT
#include "head/scene/arrays/from_arrays.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <span>

#include "base/core/hooks.h"
#include "head/scene/arrays/check.h"
#include "head/scene/arrays/read_images.h"
#include "head/scene/arrays/read_material.h"
#include "head/scene/import/complete.h"
#include "head/scene/surface/local_mesh.h"
#include "head/scene/surface/missing_uv.h"
#include "head/scene/surface/overlapping_skin.h"

namespace dermis::scene {

namespace {

using namespace arrays;

/// Returns the elements that `order` names, as a flat list; an empty order keeps all.
template <std::size_t N>
std::vector<float> gather(std::span<const std::array<float, N>> values,
                          const std::vector<std::uint32_t>& order) {
  std::vector<float> out;
  if (values.empty()) return out;
  const std::size_t count = order.empty() ? values.size() : order.size();
  out.reserve(count * N);
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<float, N>& value = values[order.empty() ? i : order[i]];
    out.insert(out.end(), value.begin(), value.end());
  }
  return out;
}

LocalMesh local_mesh(const AssetMesh& given) {
  LocalMesh mesh;
  mesh.indices.assign(given.indices.begin(), given.indices.end());
  if (given.indices.empty()) {
    mesh.indices.resize(given.positions_m.size());
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
  }

  mesh.original = drop_unused(mesh.indices, given.positions_m.size());
  mesh.vertices = mesh.original.empty() ? given.positions_m.size() : mesh.original.size();
  mesh.positions = gather(given.positions_m, mesh.original);
  mesh.normals = gather(given.normals, mesh.original);
  mesh.tangents = gather(given.tangents, mesh.original);
  mesh.uvs = {gather(given.uv0, mesh.original), gather(given.uv1, mesh.original)};
  mesh.colours = gather(given.colours, mesh.original);
  return mesh;
}

/// Numbers the materials that meshes use, in their order; those without one share glTF's default, the last.
std::vector<MaterialSource> used_materials(const AssetArrays& given, std::map<int, int>& numbers) {
  for (const AssetMesh& mesh : given.meshes) numbers[mesh.material] = 0;
  std::vector<MaterialSource> used;
  for (auto& [source, target] : numbers) {
    if (source < 0) continue;
    target = static_cast<int>(used.size());
    used.push_back(read_material(given.materials[static_cast<std::size_t>(source)]));
  }

  if (numbers.contains(-1)) {
    numbers[-1] = static_cast<int>(used.size());
    used.push_back(default_material());
  }
  return used;
}

UnusedMaterials unused_materials(const AssetArrays& given, const std::map<int, int>& numbers) {
  UnusedMaterials unused;
  for (std::size_t i = 0; i < given.materials.size(); ++i)
    if (!numbers.contains(static_cast<int>(i))) unused.add(read_material(given.materials[i]));
  return unused;
}

/// Gives meshes without a node one each, past those that are given.
std::vector<int> nodes_of(const AssetArrays& given) {
  int next = 0;
  for (const AssetMesh& mesh : given.meshes) next = std::max(next, mesh.node + 1);
  std::vector<int> nodes;
  for (const AssetMesh& mesh : given.meshes) nodes.push_back(mesh.node >= 0 ? mesh.node : next++);
  return nodes;
}

/// Usable attributes of each mesh, found by place().
struct Attributes {
  std::vector<bool> tangents;  ///< usable
  std::vector<std::array<bool, 2>> uv;
};

Primitive place(const AssetMesh& given, const Frame& frame, int material, int node, Attributes& has) {
  const LocalMesh mesh = local_mesh(given);
  Primitive out;
  out.name = given.name;
  out.material = material;
  out.node = node;
  out.has_uv = !mesh.uvs[0].empty();
  out.indices = mesh.indices;
  out.source_vertices = mesh.original;
  out.vertices.reserve(mesh.vertices);
  for (std::size_t i = 0; i < mesh.vertices; ++i) out.vertices.push_back(place_vertex(mesh, i, frame));

  has.tangents.push_back(usable_tangents(mesh, out.vertices));
  has.uv.push_back({!mesh.uvs[0].empty(), !mesh.uvs[1].empty()});
  return out;
}

/// Returns how many heads there are, each with a light map of its own.
std::size_t skin_nodes(const AssetArrays& given, const std::vector<int>& nodes,
                       const std::vector<MaterialSource>& materials, const std::map<int, int>& numbers) {
  std::set<int> heads;
  for (std::size_t i = 0; i < given.meshes.size(); ++i) {
    const auto number = static_cast<std::size_t>(numbers.at(given.meshes[i].material));
    if (!given.meshes[i].uv0.empty() && materials[number].material.skin) heads.insert(nodes[i]);
  }
  return heads.size();
}

AssetData make(const AssetArrays& given, const LoadOptions& options) {
  const std::string name = name_of(given);
  Steps steps("reading " + name, 3);
  check_images(given, options);
  check_materials(given);
  check_meshes(given, options);

  AssetData scene;
  scene.name = given.name.empty() ? name : given.name;
  std::map<int, int> numbers;
  std::vector<MaterialSource> materials = used_materials(given, numbers);
  choose_skin(name, options.skin_material, unused_materials(given, numbers), materials);
  const std::vector<int> nodes = nodes_of(given);
  check_skin_nodes(name, skin_nodes(given, nodes, materials, numbers));
  for (MaterialSource& m : materials) scene.materials.push_back(std::move(m.material));

  glm::dmat4 units(options.unit_scale);
  units[3][3] = 1;
  const Frame frame = frame_of(units);
  Attributes has;
  for (std::size_t i = 0; i < given.meshes.size(); ++i) {
    scene.primitives.push_back(
        place(given.meshes[i], frame, numbers.at(given.meshes[i].material), nodes[i], has));
    scene.primitives.back().source_mesh = static_cast<int>(i);
  }
  leave_out_maps_without_uv(name, has.uv, scene);
  steps.done();

  part_overlapping_skin(name, scene);
  complete_surfaces(has.tangents, scene);
  steps.done();

  read_images(given, static_cast<std::uint64_t>(options.texture_budget_mb * 1e6), scene);
  steps.done();

  warn_of_size(name, scene);
  return scene;
}

}  // namespace

AssetData scene_from_arrays(const AssetArrays& arrays, const LoadOptions& options) {
  return with_errors_of_import(name_of(arrays), [&] { return make(arrays, options); });
}

}  // namespace dermis::scene
