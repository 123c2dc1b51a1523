// SPDX-License-Identifier: MIT
#include "api/host_moves.h"

#include <algorithm>
#include <utility>

#include "base/core/error.h"
#include "gpu/device.h"

namespace dermis::api {
namespace {

// Returns a stream as shaders read it, up to its last element; not given: empty.
passes::DeformStream stream_of(const char* what, const vulkan::VertexStream& stream, std::uint32_t vertices,
                               const gpu::Buffer& buffer, const gpu::DeviceLimits& limits) {
  if (stream.buffer == VK_NULL_HANDLE) return {};
  if (stream.stride < 12 || stream.stride % 4 != 0 || stream.stride > 4096)
    throw input_error("", "{}.stride must be a multiple of 4 from 12 to 4096, got {}", what, stream.stride);
  if (stream.offset % 4 != 0)
    throw input_error("", "{}.offset must be a multiple of 4, got {}", what, stream.offset);
  const std::uint64_t bytes = std::uint64_t{vertices - 1} * stream.stride + 12;
  if (bytes > limits.max_storage_buffer_bytes)
    throw input_error("", "{} has {} bytes, shaders of this device read {}", what, bytes,
                      limits.max_storage_buffer_bytes);
  return {.buffer = &buffer, .offset = stream.offset, .bytes = bytes, .stride = stream.stride / 4};
}

}  // namespace

HostMoves::Moved HostMoves::make(const AssetPointer& asset) const {
  gpu::Device& device = library_->device();
  Moved moved{.asset = asset, .vertices = {}};
  for (const passes::GpuMesh& mesh : asset->gpu->skin)
    moved.vertices.emplace_back(
        device, mesh.name + " moved vertices",
        gpu::BufferDesc{.bytes = mesh.vertices.desc().bytes, .usage = mesh.vertices.desc().usage});
  device.run([&](VkCommandBuffer commands) {
    gpu::Cmd cmd(device, commands);
    for (std::size_t i = 0; i < moved.vertices.size(); ++i)
      cmd.copy(asset->gpu->skin[i].vertices, moved.vertices[i], moved.vertices[i].desc().bytes);
    cmd.barrier_all();
  });
  for (std::size_t i = 0; i < asset->data->skin.size(); ++i)
    asset->gpu->make_sources(device, i, asset->data->skin[i]);
  return moved;
}

void HostMoves::keep(const SceneOnDevice& scene, std::span<const InstanceId> ids,
                     std::span<const InstanceId> deformed) {
  std::map<InstanceId, Moved> kept;
  for (const InstanceId id : deformed) {
    // host_setup() has found it.
    const auto found = std::find(ids.begin(), ids.end(), id);
    const AssetPointer& asset = scene.asset(static_cast<std::size_t>(found - ids.begin()));
    const auto before = moved_.find(id);
    kept[id] =
        before != moved_.end() && before->second.asset == asset ? std::move(before->second) : make(asset);
  }

  if (!kept.empty() && !deform_) deform_.emplace(*library_);
  moved_ = std::move(kept);
  ids_.assign(ids.begin(), ids.end());
}

std::span<const gpu::Buffer> HostMoves::vertices_of(std::size_t instance) const {
  const auto found = moved_.find(ids_[instance]);
  return found == moved_.end() ? std::span<const gpu::Buffer>() : found->second.vertices;
}

void HostMoves::record(VkCommandBuffer commands, InstanceId instance,
                       std::span<const vulkan::DeformedMesh> meshes) const {
  const auto found = moved_.find(instance);
  if (found == moved_.end())
    throw input_error("", "instance {} is not one of HostInputs::deformed of the last update()",
                      static_cast<std::uint32_t>(instance));
  const Moved& moved = found->second;
  const gpu::DeviceLimits& limits = library_->device().limits();

  struct Move {
    std::size_t skin_mesh;
    const passes::GpuMesh::Sources* sources;
    std::vector<gpu::Buffer> of_host;
    passes::DeformStreams streams;
  };
  std::vector<Move> moves;
  for (const vulkan::DeformedMesh& mesh : meshes) {
    bool known = false;
    for (std::size_t i = 0; i < moved.vertices.size(); ++i) {
      const passes::GpuMesh::Sources* sources =
          moved.asset->gpu->skin[i].sources_of(static_cast<int>(mesh.mesh));
      if (!sources) continue;
      known = true;
      if (mesh.vertices < sources->source_vertices)
        throw input_error("", "mesh {} has {} vertices or more, got {}", mesh.mesh, sources->source_vertices,
                          mesh.vertices);

      Move& move = moves.emplace_back(Move{i, sources, {}, {}});
      for (const VkBuffer buffer : {mesh.positions_m.buffer, mesh.normals.buffer, mesh.tangents.buffer})
        move.of_host.push_back(gpu::Buffer("vertices of the host", buffer));
      move.streams = {
          .positions_m = stream_of("positions_m", mesh.positions_m, mesh.vertices, move.of_host[0], limits),
          .normals = stream_of("normals", mesh.normals, mesh.vertices, move.of_host[1], limits),
          .tangents = stream_of("tangents", mesh.tangents, mesh.vertices, move.of_host[2], limits)};
    }
    if (!known) throw input_error("", "mesh {} is not one of skin of {}", mesh.mesh, moved.asset->data->name);
  }

  gpu::Cmd cmd(library_->device(), commands);
  cmd.barrier_all();
  for (const Move& move : moves)
    deform_->record(cmd, moved.vertices[move.skin_mesh], move.sources->list, move.sources->count,
                    move.streams);
  cmd.barrier_all();
}

}  // namespace dermis::api
