// SPDX-License-Identifier: MIT
/// Heads whose vertices a host moves.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "api/scene_on_device.h"
#include "dermis/vulkan.h"
#include "render/passes/pose/deform/deform.h"

namespace dermis::api {

class HostMoves {
 public:
  explicit HostMoves(gpu::PipelineLibrary& library) : library_(&library) {}

  /// Makes vertices of their own for these instances, as their assets have them, unless they are there;
  /// forgets those of others. `ids`: of all instances. Throws InputError: one that is not of the scene.
  void keep(const SceneOnDevice& scene, std::span<const InstanceId> ids,
            std::span<const InstanceId> deformed);

  /// Returns the moved vertices of an instance, one buffer per skin mesh; empty if it is not moved.
  std::span<const gpu::Buffer> vertices_of(std::size_t instance) const;

  /// Records what the host has moved. Throws InputError, and records nothing: see
  /// vulkan::HostFrames::record_deformation().
  void record(VkCommandBuffer commands, InstanceId instance,
              std::span<const vulkan::DeformedMesh> meshes) const;

 private:
  struct Moved {
    AssetPointer asset;
    std::vector<gpu::Buffer> vertices;  // one per skin mesh
  };
  Moved make(const AssetPointer& asset) const;

  gpu::PipelineLibrary* library_;
  std::optional<passes::Deform> deform_;
  std::map<InstanceId, Moved> moved_;
  std::vector<InstanceId> ids_;
};

}  // namespace dermis::api
