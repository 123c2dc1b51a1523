// SPDX-License-Identifier: MIT
#include "frame/barriers.h"

namespace dermis::frame {
namespace {

// What is known of a resource while walking through the frame.
struct State {
  VkPipelineStageFlags2 write_stages = 0;     // of the last write
  VkAccessFlags2 write_access = 0;
  VkPipelineStageFlags2 read_stages = 0;      // of all reads since that write
  VkPipelineStageFlags2 visible_stages = 0;   // stages (with accesses) to which that write has already been made visible
  VkAccessFlags2 visible_access = 0;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  bool used = false;
};

constexpr VkAccessFlags2 write_access_mask = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
                                             VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT;

void note_use(State& state, const AccessScope& scope, bool is_write) {
  if (is_write) {
    state.write_stages = scope.stages;
    state.write_access = scope.access & write_access_mask;
    state.read_stages = 0;
    state.visible_stages = 0;
    state.visible_access = 0;
  } else {
    state.read_stages |= scope.stages;
    state.visible_stages |= scope.stages;
    state.visible_access |= scope.access;
  }
  state.layout = scope.layout;
  state.used = true;
}

// A barrier is needed for a new layout, read after write (unless already visible there), write after read, write after write.
bool needs_barrier(const State& state, const AccessScope& scope, bool is_write) {
  if (!state.used) return scope.layout != VK_IMAGE_LAYOUT_UNDEFINED;
  if (state.layout != scope.layout) return true;
  if (is_write) return true;
  const bool visible = (state.visible_stages & scope.stages) == scope.stages && (state.visible_access & scope.access) == scope.access;
  return state.write_stages != 0 && !visible;
}

Barrier make_barrier(const Use& use, const State& state, const AccessScope& scope) {
  // Reads since the last write order everything before them; waiting for them and the write is right for every hazard. A layout change
  // is itself a write: it must wait for the readers.
  return {.is_texture = use.is_texture,
          .index = use.index,
          .source_stages = state.write_stages | state.read_stages,
          .target_stages = scope.stages,
          .source_access = state.write_access,
          .target_access = scope.access,
          .old_layout = state.layout,
          .new_layout = scope.layout};
}

}  // namespace

AccessScope scope_of(Access access, PassKind kind) {
  const VkPipelineStageFlags2 shader =
      kind == PassKind::compute ? VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT
                                : VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
  switch (access) {
    case Access::sampled: return {shader, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    case Access::storage_read: return {shader, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, VK_IMAGE_LAYOUT_GENERAL};
    case Access::storage_write:
      return {shader, VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL};
    case Access::colour_target:
      return {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
              VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    case Access::depth_target:
      return {VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
              VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
              VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL};
    case Access::copy_source: return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
    case Access::copy_target: return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
    case Access::indirect_arguments:
      return {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, VK_IMAGE_LAYOUT_UNDEFINED};
  }
  return {};
}

std::vector<std::vector<Barrier>> derive_barriers(const FramePlan& plan, bool counting) {
  std::vector<State> textures(plan.textures().size()), buffers(plan.buffers().size());
  std::vector<std::vector<Barrier>> result(plan.passes().size());
  // Two walks: the first finds how a frame leaves each resource, the second starts from there.
  for (const bool second_walk : {false, true}) {
    std::vector<bool> seen_texture(textures.size()), seen_buffer(buffers.size());
    for (std::size_t p = 0; p < plan.passes().size(); ++p) {
      const PassNode& pass = plan.passes()[p];
      if (pass.only_when_counting && !counting) continue;
      for (const Use& use : pass.uses) {
        State& state = use.is_texture ? textures[use.index] : buffers[use.index];
        AccessScope scope = scope_of(use.access, pass.kind);
        if (!use.is_texture) scope.layout = VK_IMAGE_LAYOUT_UNDEFINED;
        auto&& seen = use.is_texture ? seen_texture[use.index] : seen_buffer[use.index];
        const bool first = !seen;
        seen = true;
        const Lifetime lifetime = use.is_texture ? plan.textures()[use.index].lifetime : plan.buffers()[use.index].lifetime;
        if (second_walk) {
          const bool discard = first && use.is_texture && lifetime == Lifetime::transient;
          if (discard || needs_barrier(state, scope, writes(use.access))) {
            Barrier barrier = make_barrier(use, state, scope);
            barrier.first_use = first;
            if (discard) barrier.old_layout = VK_IMAGE_LAYOUT_UNDEFINED;
            result[p].push_back(barrier);
            if (barrier.old_layout != barrier.new_layout) state.write_stages |= scope.stages;   // later readers in other stages wait for the transition
          }
        }
        note_use(state, scope, writes(use.access));
      }
    }
  }
  return result;
}

VkImageLayout final_layout(const FramePlan& plan, TextureId id, bool counting) {
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  for (const PassNode& pass : plan.passes())
    for (const Use& use : pass.uses)
      if ((counting || !pass.only_when_counting) && use.is_texture && use.index == id.index) layout = scope_of(use.access, pass.kind).layout;
  return layout;
}

}  // namespace dermis::frame
