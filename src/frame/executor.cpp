// SPDX-License-Identifier: MIT
#include "frame/executor.h"

#include <chrono>
#include <exception>

namespace dermis::frame {
namespace {

using Clock = std::chrono::steady_clock;
double ms_since(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

}  // namespace

const gpu::Texture& Resources::texture(TextureId id) const {
  DERMIS_ASSERT_LT(id.index, textures_.size());
  return textures_[id.index];
}

const gpu::Buffer& Resources::buffer(BufferId id) const {
  DERMIS_ASSERT_LT(id.index, buffers_.size());
  return buffers_[id.index];
}

Executor::Executor(gpu::PipelineLibrary& library, FramePlan plan)
    : library_(&library), plan_(std::move(plan)), barriers_{derive_barriers(plan_, false), derive_barriers(plan_, true)}, separate_(library.device().limits().software || !library.device().limits().timestamps) {
  for (const TextureNode& node : plan_.textures()) resources_.textures_.emplace_back(library.device(), node.name, node.desc);
  for (const BufferNode& node : plan_.buffers()) resources_.buffers_.emplace_back(library.device(), node.name, node.desc);
  for (const PassNode& pass : plan_.passes())
    if (pass.prepare) pass.prepare(library);
}

void Executor::record_pass(gpu::Cmd& cmd, std::size_t index, const FrameData& frame, bool counting) {
  std::vector<VkImageMemoryBarrier2> images;
  std::vector<VkBufferMemoryBarrier2> buffers;
  for (const Barrier& b : barriers_[counting ? 1 : 0][index]) {
    if (b.is_texture) {
      const gpu::Texture& texture = resources_.textures_[b.index];
      VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
      barrier.srcStageMask = b.source_stages, barrier.srcAccessMask = b.source_access;
      barrier.dstStageMask = b.target_stages, barrier.dstAccessMask = b.target_access;
      barrier.oldLayout = first_frame_ && b.first_use ? VK_IMAGE_LAYOUT_UNDEFINED : b.old_layout;
      barrier.newLayout = b.new_layout;
      barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
      barrier.image = texture.handle();
      barrier.subresourceRange = {gpu::aspect_of(texture.desc().format), 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
      images.push_back(barrier);
    } else {
      VkBufferMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2};
      barrier.srcStageMask = b.source_stages, barrier.srcAccessMask = b.source_access;
      barrier.dstStageMask = b.target_stages, barrier.dstAccessMask = b.target_access;
      barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
      barrier.buffer = resources_.buffers_[b.index].handle();
      barrier.size = VK_WHOLE_SIZE;
      buffers.push_back(barrier);
    }
  }
  if (!images.empty() || !buffers.empty()) {
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size());
    info.pImageMemoryBarriers = images.data();
    info.bufferMemoryBarrierCount = static_cast<std::uint32_t>(buffers.size());
    info.pBufferMemoryBarriers = buffers.data();
    cmd.barrier(info);
  }
  plan_.passes()[index].record(cmd, resources_, frame);
}

void Executor::record(VkCommandBuffer commands, const FrameData& frame, gpu::Timer* timer, bool counting) {
  gpu::Cmd cmd(device(), commands);
  if (timer) timer->reset(commands);
  for (std::size_t p = 0; p < plan_.passes().size(); ++p) {
    if (plan_.passes()[p].only_when_counting && !counting) continue;
    const std::string& name = plan_.passes()[p].name;
    device().begin_label(commands, name);
    if (timer) timer->begin(commands, name);
    record_pass(cmd, p, frame, counting);
    if (timer) timer->end(commands);
    device().end_label(commands);
  }
  first_frame_ = false;
}

FrameTime Executor::run(const FrameData& frame) {
  FrameTime time;
  if (separate_) {
    for (std::size_t p = 0; p < plan_.passes().size(); ++p) {
      if (plan_.passes()[p].only_when_counting) continue;
      const auto start = Clock::now();
      device().run([&](VkCommandBuffer commands) {
        gpu::Cmd cmd(device(), commands);
        record_pass(cmd, p, frame, false);
      });
      time.passes.push_back({plan_.passes()[p].name, ms_since(start)});
      time.total_ms += time.passes.back().ms;
    }
    first_frame_ = false;
    return time;
  }
  gpu::Timer timer(device(), static_cast<std::uint32_t>(plan_.passes().size()) + 1);
  device().run([&](VkCommandBuffer commands) { record(commands, frame, &timer); });
  for (const gpu::Timing& pass : timer.read()) {
    time.passes.push_back({pass.name, pass.ms});
    time.total_ms += pass.ms;
  }
  return time;
}

void Executor::run_counting(const FrameData& frame) {
  device().run([&](VkCommandBuffer commands) { record(commands, frame, nullptr, true); });
}

}  // namespace dermis::frame
