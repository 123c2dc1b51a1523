// SPDX-License-Identifier: MIT
#include "frame/executor.h"

#include <chrono>
#include <utility>

namespace dermis::frame {
GraphExecutor::GraphExecutor(gpu::PipelineLibrary& library, const FrameGraph& graph)
    : library_(&library),
      graph_(graph),
      layouts_(graph.textures().size(), VK_IMAGE_LAYOUT_UNDEFINED),
      separate_(library.device().limits().software || !library.device().limits().timestamps) {
  for (std::uint32_t i = 0; i < graph.textures().size(); ++i)
    resources_.sampled_layouts_.push_back(graph.layout_in(i, Access::sampled));
  for (const TextureNode& node : graph.textures())
    if (node.lifetime == Lifetime::of_host)
      resources_.textures_.emplace_back();
    else
      resources_.textures_.emplace_back(library.device(), node.name, node.desc);
  for (const BufferNode& node : graph.buffers())
    resources_.buffers_.emplace_back(library.device(), node.name, node.desc);
  resources_.nearest_ = library.sampler({.filter = gpu::Filter::nearest});
  resources_.linear_ = library.sampler({.filter = gpu::Filter::linear});
}

void GraphExecutor::set_texture_of_host(TextureId id, gpu::Texture texture) {
  DERMIS_ASSERT(graph_.textures()[id.index].lifetime == Lifetime::of_host);
  resources_.textures_[id.index] = std::move(texture);
}

bool GraphExecutor::is_of_host(const Barrier& b) const {
  return b.is_texture && graph_.textures()[b.index].lifetime == Lifetime::of_host;
}

// The layout in which the frame before left a texture depends on the kind of that frame.
VkImageLayout GraphExecutor::old_layout(const Barrier& b) const {
  const bool keeps = b.first_use && b.old_layout != VK_IMAGE_LAYOUT_UNDEFINED;
  return keeps ? layouts_[b.index] : b.old_layout;
}

VkImageMemoryBarrier2 GraphExecutor::image_barrier(const Barrier& b) {
  const gpu::Texture& texture = resources_.textures_[b.index];
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = b.source_stages, barrier.srcAccessMask = b.source_access;
  barrier.dstStageMask = b.target_stages, barrier.dstAccessMask = b.target_access;
  barrier.oldLayout = old_layout(b), barrier.newLayout = b.new_layout;
  layouts_[b.index] = b.new_layout;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = texture.handle();
  barrier.subresourceRange = {gpu::aspect_of(texture.desc().format), 0, VK_REMAINING_MIP_LEVELS, 0,
                              VK_REMAINING_ARRAY_LAYERS};
  return barrier;
}

const GraphExecutor::Barriers& GraphExecutor::barriers_of(const FrameKind& kind) {
  const auto [entry, is_new] = barriers_.try_emplace(kind);
  if (is_new) entry->second = derive_barriers(graph_, kind);
  return entry->second;
}

void GraphExecutor::record_barriers(gpu::Cmd& cmd, const std::vector<Barrier>& barriers) {
  if (barriers.empty()) return;
  std::vector<VkImageMemoryBarrier2> images;
  // Where no layout changes, one barrier of all memory does what one per resource would, for less. A target
  // of the host keeps its layout.
  VkMemoryBarrier2 memory{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  for (const Barrier& b : barriers) {
    if (b.is_texture && !is_of_host(b) && old_layout(b) != b.new_layout) {
      images.push_back(image_barrier(b));
      continue;
    }
    memory.srcStageMask |= b.source_stages, memory.srcAccessMask |= b.source_access;
    memory.dstStageMask |= b.target_stages, memory.dstAccessMask |= b.target_access;
  }
  const bool waits = memory.dstStageMask != 0;
  cmd.barrier({.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
               .memoryBarrierCount = waits ? 1u : 0u,
               .pMemoryBarriers = &memory,
               .imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size()),
               .pImageMemoryBarriers = images.data()});
}

void GraphExecutor::record(VkCommandBuffer commands, const RecordPass& record_pass, FrameKind kind,
                           gpu::Timer* timer) {
  kind.first = kind.first || std::exchange(first_, false);
  const Barriers& barriers = barriers_of(kind);
  gpu::Cmd cmd(device(), commands);
  if (timer) timer->reset(commands);
  for (std::size_t p = 0; p < graph_.passes().size(); ++p) {
    if (!kind.has(graph_.passes()[p].runs)) continue;
    const std::string& name = graph_.passes()[p].name;
    device().begin_label(commands, name);
    if (timer) timer->begin(commands, name);
    record_barriers(cmd, barriers[p]);
    record_pass(cmd, p);
    if (timer) timer->end(commands);
    device().end_label(commands);
  }
  recorded_ = cmd.recorded();
}

void GraphExecutor::poison() {
  for (std::size_t i = 0; i < resources_.textures_.size(); ++i) {
    const Lifetime lifetime = graph_.textures()[i].lifetime;
    const bool lasts = lifetime == Lifetime::persistent && layouts_[i] != VK_IMAGE_LAYOUT_UNDEFINED;
    if (lasts || lifetime == Lifetime::of_host || resources_.textures_[i].desc().samples > 1) continue;
    gpu::poison(device(), resources_.textures_[i]);
    layouts_[i] = VK_IMAGE_LAYOUT_UNDEFINED;
  }
}

FrameTime GraphExecutor::run(const RecordPass& record_pass) {
  using namespace std::chrono;
  FrameTime time;

  if (separate_) {
    const FrameKind kind{.first = std::exchange(first_, false)};
    const Barriers& barriers = barriers_of(kind);
    recorded_ = {};
    auto last = gpu::Cmd::Work::none;
    for (std::size_t p = 0; p < graph_.passes().size(); ++p) {
      if (!kind.has(graph_.passes()[p].runs)) continue;
      const auto start = steady_clock::now();
      device().run([&](VkCommandBuffer commands) {
        gpu::Cmd cmd(device(), commands, last);
        record_barriers(cmd, barriers[p]);
        record_pass(cmd, p);
        recorded_ += cmd.recorded();
        last = cmd.last();
      });
      time.passes.push_back(
          {graph_.passes()[p].name, duration<double, std::milli>(steady_clock::now() - start).count()});
    }
  } else {
    gpu::Timer timer(device(), static_cast<std::uint32_t>(graph_.passes().size()) + 1);
    device().run([&](VkCommandBuffer commands) { record(commands, record_pass, {}, &timer); });
    time.passes = timer.read();
  }

  for (const gpu::Timing& pass : time.passes) time.total_ms += pass.ms;
  return time;
}

}  // namespace dermis::frame
