// SPDX-License-Identifier: MIT
#include "render/passes/asset/gpu_rig.h"

#include <fmt/format.h>

#include <span>
#include <utility>

#include "base/core/error.h"
#include "gpu/device.h"
#include "head/scene/surface/turned.h"
#include "render/passes/asset/charts_first.h"
#include "render/shared/rig_io.h"

namespace dermis::passes {
namespace {

// Collects the vertices of one buffer.
class Builder {
 public:
  explicit Builder(const scene::Rig& rig) : rig_(rig) {}

  void add(std::uint32_t primitive, std::uint32_t vertex) {
    const scene::RigMesh& mesh = rig_.meshes[primitive];
    io::RigVertexIo& out = vertices_.emplace_back(io::RigVertexIo{});
    out.first_influence = out.end_influence = static_cast<std::uint32_t>(influences_.size());
    out.first_delta = out.end_delta = static_cast<std::uint32_t>(deltas_.size());
    if (!mesh.placed.empty()) return;  // placements move

    const std::uint32_t from = mesh.source_of(vertex);
    out.position = mesh.positions[from];
    out.normal = mesh.normals[from];
    out.tangent = mesh.tangents[vertex];
    for (std::uint32_t i = mesh.first_influence[from]; i < mesh.first_influence[from + 1]; ++i)
      influences_.push_back({.matrix = mesh.influences[i].matrix, .weight = mesh.influences[i].weight});
    for (std::uint32_t i = mesh.first_delta[from]; i < mesh.first_delta[from + 1]; ++i)
      deltas_.push_back({.position = mesh.deltas[i].position,
                         .normal = mesh.deltas[i].normal,
                         .tangent = mesh.deltas[i].tangent,
                         .weight = mesh.deltas[i].weight});
    out.end_influence = static_cast<std::uint32_t>(influences_.size());
    out.end_delta = static_cast<std::uint32_t>(deltas_.size());
  }

  GpuRig::Part upload(gpu::Device& device, const std::string& name) {
    GpuRig::Part part;
    part.count = static_cast<std::uint32_t>(vertices_.size());
    part.vertices = make(device, name + " before poses", vertices_);
    part.influences = make(device, name + " influences", influences_);
    part.deltas = make(device, name + " morph targets", deltas_);
    return part;
  }

 private:
  template <class T>
  static gpu::Buffer make(gpu::Device& device, const std::string& name, std::vector<T>& values) {
    if (values.empty()) values.push_back(T{});  // Vulkan has no empty buffers
    const std::uint64_t bytes = values.size() * sizeof(T), most = device.limits().max_storage_buffer_bytes;
    if (bytes > most)
      throw device_error("{}: {} bytes, shaders of this device read {}; without a pose it can be drawn", name,
                         bytes, most);
    return gpu::make_buffer(device, name, std::span<const T>(values), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  }

  const scene::Rig& rig_;
  std::vector<io::RigVertexIo> vertices_;
  std::vector<io::InfluenceIo> influences_;
  std::vector<io::MorphDeltaIo> deltas_;
};

gpu::Buffer make_list(gpu::Device& device, const std::string& name, const std::vector<std::uint32_t>& list) {
  return gpu::make_buffer(device, name, std::span<const std::uint32_t>(list),
                          VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

}  // namespace

GpuRig upload_rig(gpu::Device& device, const scene::AssetData& scene, const GpuSurfaces& surfaces) {
  GpuRig rig;
  for (const scene::SkinMesh& mesh : scene.skin) {
    Builder builder(*scene.rig);
    for (const scene::PrimitiveVertex& origin : mesh.origins) builder.add(origin.primitive, origin.vertex);
    const std::string name = fmt::format("skin {}", rig.parts.size());
    rig.parts.push_back(builder.upload(device, name));

    const scene::SkinMesh sorted = charts_first(mesh);
    rig.skin.push_back(
        {.metric_triangles =
             make_list(device, name + " metric", scene::metric_triangles(sorted, scene.mm_per_unit)),
         .touching_neighbours = make_list(device, name + " neighbours", scene::touching_neighbours(sorted))});
  }

  for (const GpuSurfaces::Page& page : surfaces.pages) {
    Builder builder(*scene.rig);
    for (const GpuSurfaces::Page::Part& part : page.parts)
      for (std::uint32_t v = 0; v < scene.primitives[part.primitive].vertices.size(); ++v)
        builder.add(part.primitive, v);
    rig.parts.push_back(
        builder.upload(device, fmt::format("surfaces {}", rig.parts.size() - scene.skin.size())));
  }
  return rig;
}

}  // namespace dermis::passes
