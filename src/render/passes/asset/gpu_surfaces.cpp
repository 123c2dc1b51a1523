// SPDX-License-Identifier: MIT
#include "render/passes/asset/gpu_surfaces.h"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>

#include "base/core/error.h"
#include "gpu/device.h"
#include "head/scene/placement.h"
#include "render/passes/asset/vertices.h"

namespace dermis::passes {
namespace {

constexpr VkBufferUsageFlags surface_storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

io::PlacementIo placement_io(const scene::Placement& placement) {
  const glm::mat4x3 m(placement.world_from_mesh);
  const glm::mat3 n(scene::normal_matrix(placement));
  return {.x_axis = m[0],
          .y_axis = m[1],
          .z_axis = m[2],
          .origin_m = m[3],
          .normal_x = n[0],
          .normal_y = n[1],
          .normal_z = n[2],
          .handedness = placement.mirrored ? -1.0f : 1.0f};
}

// The data of one page before its upload.
struct PageData {
  std::vector<io::VertexIo> vertices;
  std::vector<io::VertexExtraIo> extras;
  std::vector<std::uint32_t> indices;
  std::vector<io::PlacementIo> placements{io::PlacementIo{}};
  std::vector<GpuSurfaces::Page::Part> parts;
  std::vector<GpuSurfaces::Page::Copy> copies;
};

class SurfaceBuilder {
 public:
  SurfaceBuilder(gpu::Device& device, const scene::AssetData& scene) : device_(&device), scene_(&scene) {}

  bool is_blended(const scene::Primitive& p) const {
    return scene_->materials[static_cast<std::size_t>(p.material)].alpha_mode == AssetAlpha::blend;
  }

  void add(const scene::Primitive& p) {
    make_room(p);
    const auto base = static_cast<std::uint32_t>(page_.vertices.size());
    const auto number = static_cast<std::uint32_t>(&p - scene_->primitives.data());
    page_.parts.push_back({number, base});
    for (const scene::Vertex& v : p.vertices) {
      page_.vertices.push_back(vertex_io(v));
      page_.extras.push_back(vertex_extra_io(v));
    }
    if (p.placements.empty()) return add_draw(p, 0, {append_indices(p, base, false), count(p), 0, 1});

    // Mirrored copies wind the other way round.
    for (const bool mirrored : {false, true}) {
      const auto first = static_cast<std::uint32_t>(page_.placements.size());
      std::vector<std::size_t> copies;
      for (std::size_t copy = 0; copy < p.placements.size(); ++copy)
        if (p.placements[copy].mirrored == mirrored) copies.push_back(copy);
      if (copies.empty()) continue;
      for (const std::size_t copy : copies) {
        page_.placements.push_back(placement_io(p.placements[copy]));
        page_.copies.push_back({number, static_cast<std::uint32_t>(copy)});
      }

      const std::uint32_t first_index = append_indices(p, base, mirrored);
      const auto placements = static_cast<std::uint32_t>(copies.size());
      if (!is_blended(p)) {
        add_draw(p, 0, {first_index, count(p), first, placements});
        continue;
      }
      for (std::uint32_t i = 0; i < placements; ++i)
        add_draw(p, copies[i], {first_index, count(p), first + i, 1});
    }
  }

  GpuSurfaces finish() {
    flush();
    return std::move(made_);
  }

 private:
  static std::uint32_t count(const scene::Primitive& p) {
    return static_cast<std::uint32_t>(p.indices.size());
  }

  void make_room(const scene::Primitive& p) {
    const std::uint64_t most = device_->limits().max_storage_buffer_bytes;
    const bool fits = (page_.vertices.size() + p.vertices.size()) * sizeof(io::VertexIo) <= most &&
                      (page_.indices.size() + 2 * p.indices.size()) * sizeof(std::uint32_t) <= most &&
                      (page_.placements.size() + p.placements.size()) * sizeof(io::PlacementIo) <= most;
    if (!fits) flush();
  }

  std::uint32_t append_indices(const scene::Primitive& p, std::uint32_t base, bool mirrored) {
    const std::size_t first = page_.indices.size();
    for (const std::uint32_t index : p.indices) page_.indices.push_back(base + index);
    for (std::size_t i = first; mirrored && i + 2 < page_.indices.size(); i += 3)
      std::swap(page_.indices[i + 1], page_.indices[i + 2]);
    return static_cast<std::uint32_t>(first);
  }

  void add_draw(const scene::Primitive& p, std::size_t copy, const GpuSurfaces::Draw& draw) {
    const auto page = static_cast<std::uint32_t>(made_.pages.size());
    if (is_blended(p)) {
      glm::vec3 low(INFINITY), high(-INFINITY);
      for (std::uint32_t v = 0; v < p.vertices.size(); ++v) {
        const glm::vec3 position_m = scene::world_position_m(p, copy, v);
        low = glm::min(low, position_m);
        high = glm::max(high, position_m);
      }
      made_.blended.push_back({(low + high) * 0.5f, page, p.material, draw});
      return;
    }

    const auto [entry, is_new] = group_of_.try_emplace(p.material, made_.groups.size());
    if (is_new) made_.groups.push_back({page, p.material, {}});
    std::vector<GpuSurfaces::Draw>& draws = made_.groups[entry->second].draws;
    // Meshes with one copy are in world coordinates: neighbours in the buffer become one draw.
    if (!draws.empty() && draw.first_placement == 0 && draws.back().first_placement == 0 &&
        draws.back().first_index + draws.back().index_count == draw.first_index)
      draws.back().index_count += draw.index_count;
    else
      draws.push_back(draw);
  }

  void flush() {
    if (page_.indices.empty()) return;
    const std::string name = "surfaces " + std::to_string(made_.pages.size());
    GpuSurfaces::Page page;
    page.vertices = gpu::make_buffer(*device_, name + " vertices",
                                     std::span<const io::VertexIo>(page_.vertices), gpu::texels_of_shaders);
    join_equal(page_.extras);
    page.vertex_extras =
        gpu::make_buffer(*device_, name + " vertex extras", std::span<const io::VertexExtraIo>(page_.extras),
                         gpu::texels_of_shaders);
    page.indices =
        gpu::make_buffer(*device_, name + " indices", std::span<const std::uint32_t>(page_.indices),
                         VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    page.placements = gpu::make_buffer(*device_, name + " placements",
                                       std::span<const io::PlacementIo>(page_.placements), surface_storage);
    page.parts = std::move(page_.parts);
    page.copies = std::move(page_.copies);
    made_.pages.push_back(std::move(page));
    page_ = {};
    group_of_.clear();
  }

  gpu::Device* device_;
  const scene::AssetData* scene_;
  PageData page_;
  std::map<int, std::size_t> group_of_;  // of the page, by material
  GpuSurfaces made_;
};

}  // namespace

void GpuSurfaces::record(gpu::Cmd& cmd, std::uint32_t page, const Draw& draw) const {
  cmd.draw_indexed({&pages[page].indices}, draw.index_count, draw.first_index, draw.placements,
                   draw.first_placement);
}

GpuSurfaces upload_surfaces(gpu::Device& device, const scene::AssetData& scene) {
  SurfaceBuilder builder(device, scene);
  std::vector<const scene::Primitive*> parts;
  for (const scene::Primitive& p : scene.primitives)
    if (!scene.materials[static_cast<std::size_t>(p.material)].skin) parts.push_back(&p);

  // Sorts by material, meshes with one copy first: they are adjacent and become one draw. Blended ones keep
  // their order, which decides between equally distant ones.
  std::stable_sort(parts.begin(), parts.end(), [&](const scene::Primitive* a, const scene::Primitive* b) {
    const auto key = [&](const scene::Primitive* p) {
      return builder.is_blended(*p) ? std::tuple(true, 0, false)
                                    : std::tuple(false, p->material, !p->placements.empty());
    };
    return key(a) < key(b);
  });
  for (const scene::Primitive* p : parts) builder.add(*p);
  return builder.finish();
}

std::vector<io::PlacementIo> posed_placements(const GpuSurfaces::Page& page, const scene::AssetData& scene,
                                              const scene::PosedRig& pose) {
  std::vector<io::PlacementIo> placements{io::PlacementIo{}};
  for (const GpuSurfaces::Page::Copy& copy : page.copies) {
    const scene::RigMesh& mesh = scene.rig->meshes[copy.primitive];
    const glm::dmat4& matrix = pose.matrices[mesh.placed[copy.copy]];
    scene::Placement placement = scene.primitives[copy.primitive].placements[copy.copy];
    placement.world_from_mesh = glm::dmat4x3(matrix);
    placement.world_from_mesh[3] = glm::dvec3(matrix * glm::dvec4(mesh.middle, 1));
    placements.push_back(placement_io(placement));
  }
  return placements;
}

gpu::Buffer unmoved(gpu::Device& device) {
  const io::PlacementIo placement{};
  return gpu::make_buffer(device, "unmoved", std::span(&placement, 1), surface_storage);
}

}  // namespace dermis::passes
