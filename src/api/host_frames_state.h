// SPDX-License-Identifier: MIT
/// State of HostFrames: a plan, memory for each frame in flight, and the inputs of the host.
#pragma once

#include <memory>
#include <vector>

#include "api/host_moves.h"
#include "api/host_records.h"
#include "api/planned_frame.h"
#include "dermis/vulkan.h"
#include "gpu/frame_memory.h"
#include "render/passes/pixels/host_depth/host_depth.h"

namespace dermis::vulkan {

/// Images of a host that a setup points to.
using HostImages = std::vector<std::unique_ptr<gpu::Texture>>;

struct HostFrames::State {
  State(std::shared_ptr<Renderer::State> renderer, const Options& wanted);

  /// Memory of one frame in flight.
  struct Slot {
    Slot(gpu::Device& device, std::size_t number) : memory(device, fmt::format("frame {}", number)) {}
    gpu::FrameMemory memory;
    std::uint64_t frame = 0;  ///< the last that used it
  };
  struct Filled {
    passes::FrameData data;
    gpu::BufferBinding records;
  };

  void update(const Scene& wanted, const RenderSettings& settings, const HostInputs& wanted_inputs);
  Recorded record(VkCommandBuffer commands, std::span<const View> views, const FrameNumbers& numbers);
  void record_depth(VkCommandBuffer commands, const std::array<double, 16>& clip_from_world,
                    const DepthView& view);
  std::uint32_t record_of(InstanceId instance, std::uint32_t skin_mesh) const;
  void check_ready() const;

  Options options;
  api::PlannedFrame frame;
  std::vector<std::unique_ptr<Slot>> slots;
  std::vector<passes::HostDepth> depths;
  FrameNumbers last;

  // Of the last update().
  Scene scene;
  HostInputs inputs;
  HostImages images;
  api::HostRecords records;
  api::HostMoves move{frame.renderer().library};
  std::vector<InstanceId> ids;

 private:
  Filled fill(Slot& slot, bool measured = false);
  Slot& begin(const FrameNumbers& numbers);
  void set_targets(const View& view);
  passes::DrawIrradiance irradiance_drawer(const gpu::BufferBinding& records_at) const;
};

/// Returns what a setup needs of a host's options and inputs; it points to what it adds to `images`. Throws
/// InputError for inputs that do not fit the scene or the settings.
setup::HostSetup host_setup(const HostFrames::Options& options, const Scene& scene,
                            const RenderSettings& settings, const HostInputs& inputs, HostImages& images);

}  // namespace dermis::vulkan
