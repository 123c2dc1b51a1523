// SPDX-License-Identifier: MIT
/// The heads of a frame as dermis/scattered.glsl knows them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "api/scene_on_device.h"
#include "render/passes/frame_data.h"

namespace dermis::api {

/// DermisRecord of include/dermis/scattered.glsl.
struct HostRecord {
  glm::vec2 uv_scale{1}, uv_offset{0};
  glm::vec2 origin{0};
  float side = 0;
  std::uint32_t layer = 0;
  std::uint32_t lit = 0;
  float unlit_rest = 1;
};
static_assert(sizeof(HostRecord) == 40);

/// Numbers the records: one per instance and skin mesh of its asset, in the order of the scene.
class HostRecords {
 public:
  HostRecords() = default;
  HostRecords(std::span<const AssetPointer> assets, float unlit_rest);

  /// Returns those of a frame.
  std::vector<HostRecord> of(const passes::FrameData& frame) const;
  std::uint32_t number(std::size_t instance, std::uint32_t mesh) const { return first_[instance] + mesh; }
  std::uint32_t meshes(std::size_t instance) const { return first_[instance + 1] - first_[instance]; }

 private:
  std::vector<std::uint32_t> first_{0};  // of each instance, and the end
  std::vector<HostRecord> unlit_;        // with the fit of their unwraps
};

}  // namespace dermis::api
