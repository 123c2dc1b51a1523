// SPDX-License-Identifier: MIT
#include "frame/executor.h"

#include <chrono>

namespace dermis::frame {
Executor::Executor(gpu::PipelineLibrary& library, FramePlan plan)
    : library_(&library),
      plan_(std::move(plan)),
      barriers_{derive_barriers(plan_, false), derive_barriers(plan_, true)},
      layouts_(plan_.textures().size(), VK_IMAGE_LAYOUT_UNDEFINED),
      separate_(library.device().limits().software || !library.device().limits().timestamps) {
  for (const TextureNode& node : plan_.textures())
    resources_.textures_.emplace_back(library.device(), node.name, node.desc);
  for (const BufferNode& node : plan_.buffers())
    resources_.buffers_.emplace_back(library.device(), node.name, node.desc);
  for (const PassNode& pass : plan_.passes())
    if (pass.prepare) pass.prepare(library);
}

VkImageMemoryBarrier2 Executor::image_barrier(const Barrier& b) {
  const gpu::Texture& texture = resources_.textures_[b.index];
  // How the frame before left a texture depends on whether that one counted.
  const bool keeps = b.first_use && b.old_layout != VK_IMAGE_LAYOUT_UNDEFINED;
  const VkImageLayout old_layout = keeps ? layouts_[b.index] : b.old_layout;
  layouts_[b.index] = b.new_layout;
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = b.source_stages, barrier.srcAccessMask = b.source_access;
  barrier.dstStageMask = b.target_stages, barrier.dstAccessMask = b.target_access;
  barrier.oldLayout = old_layout, barrier.newLayout = b.new_layout;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = texture.handle();
  barrier.subresourceRange = {gpu::aspect_of(texture.desc().format), 0, VK_REMAINING_MIP_LEVELS, 0,
                              VK_REMAINING_ARRAY_LAYERS};
  return barrier;
}

void Executor::record_pass(gpu::Cmd& cmd, std::size_t index, const FrameData& frame, bool full) {
  std::vector<VkImageMemoryBarrier2> images;
  // on one queue a barrier of a buffer says no more than one of all memory
  std::vector<VkMemoryBarrier2> buffers;
  for (const Barrier& b : barriers_[full ? 1 : 0][index])
    if (b.is_texture)
      images.push_back(image_barrier(b));
    else
      buffers.push_back({VK_STRUCTURE_TYPE_MEMORY_BARRIER_2, nullptr, b.source_stages, b.source_access,
                         b.target_stages, b.target_access});
  if (!images.empty() || !buffers.empty())
    cmd.barrier({.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                 .memoryBarrierCount = static_cast<std::uint32_t>(buffers.size()),
                 .pMemoryBarriers = buffers.data(),
                 .imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size()),
                 .pImageMemoryBarriers = images.data()});
  plan_.passes()[index].record(cmd, resources_, frame);
}

void Executor::record(VkCommandBuffer commands, const FrameData& frame, gpu::Timer* timer, bool full) {
  gpu::Cmd cmd(device(), commands);
  if (timer) timer->reset(commands);
  for (std::size_t p = 0; p < plan_.passes().size(); ++p) {
    if (plan_.passes()[p].only_in_full_frames && !full) continue;
    const std::string& name = plan_.passes()[p].name;
    device().begin_label(commands, name);
    if (timer) timer->begin(commands, name);
    record_pass(cmd, p, frame, full);
    if (timer) timer->end(commands);
    device().end_label(commands);
  }
}

void Executor::poison() {
  for (std::size_t i = 0; i < resources_.textures_.size(); ++i) {
    const bool lasts =
        plan_.textures()[i].lifetime == Lifetime::persistent && layouts_[i] != VK_IMAGE_LAYOUT_UNDEFINED;
    if (!lasts && resources_.textures_[i].desc().samples == 1) gpu::poison(device(), resources_.textures_[i]);
  }
}

FrameTime Executor::run(const FrameData& frame) {
  using namespace std::chrono;
  FrameTime time;

  if (separate_) {
    for (std::size_t p = 0; p < plan_.passes().size(); ++p) {
      if (plan_.passes()[p].only_in_full_frames) continue;
      const auto start = steady_clock::now();
      device().run([&](VkCommandBuffer commands) {
        gpu::Cmd cmd(device(), commands);
        record_pass(cmd, p, frame, false);
      });
      time.passes.push_back(
          {plan_.passes()[p].name, duration<double, std::milli>(steady_clock::now() - start).count()});
    }
  } else {
    gpu::Timer timer(device(), static_cast<std::uint32_t>(plan_.passes().size()) + 1);
    device().run([&](VkCommandBuffer commands) { record(commands, frame, &timer); });
    time.passes = timer.read();
  }

  for (const gpu::Timing& pass : time.passes) time.total_ms += pass.ms;
  return time;
}

}  // namespace dermis::frame
