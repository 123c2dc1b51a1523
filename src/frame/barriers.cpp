// SPDX-License-Identifier: MIT
#include "frame/barriers.h"

#include <algorithm>
#include <utility>

namespace dermis::frame {
namespace {

// The state of a resource on the walk through the frame. A layout change counts as a write by the stages that
// wait for it.
struct State {
  VkPipelineStageFlags2 write_stages = 0;  // of the last write
  VkAccessFlags2 write_access = 0;         // 0 after a layout change, which is available by itself
  VkPipelineStageFlags2 read_stages = 0;   // of all reads since the last write
  VkAccessFlags2 visible_access = 0;       // of those reads, to which the write is already visible
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

void note_use(State& state, const AccessRow& scope) {
  if (scope.written != 0) {
    state = {.write_stages = scope.stages, .write_access = scope.written, .layout = scope.layout};
  } else {
    state.read_stages |= scope.stages;
    state.visible_access |= scope.read;
  }
}

// Returns whether a use needs a barrier: new layout, write after read, write after write, and read after
// write unless the write is already visible there.
bool needs_barrier(const State& state, const AccessRow& scope) {
  if (scope.written != 0 || state.layout != scope.layout) return true;
  const bool visible =
      (state.read_stages & scope.stages) == scope.stages && (state.visible_access & scope.read) == scope.read;
  return state.write_stages != 0 && !visible;
}

Barrier make_barrier(const Use& use, const State& state, const AccessRow& scope, bool first_use,
                     bool discard) {
  // Reads since the last write order everything before them: waiting for them and for the write is right for
  // every hazard.
  return {.is_texture = use.is_texture,
          .index = use.index,
          .source_stages = state.write_stages | state.read_stages,
          .target_stages = scope.stages,
          .source_access = state.write_access,
          .target_access = scope.read | scope.written,
          .old_layout = discard ? VK_IMAGE_LAYOUT_UNDEFINED : state.layout,
          .new_layout = scope.layout,
          .first_use = first_use};
}

// Returns the row of an access with the stages of this pass and the layout of this resource: a buffer has
// none.
AccessRow scope_of(const FrameGraph& graph, const Use& use, PassKind kind) {
  constexpr VkPipelineStageFlags2 raster =
      VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
  AccessRow row = row_of(use.access);
  if (row.stages == 0)
    row.stages = kind == PassKind::compute ? VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT : raster;
  row.layout = use.is_texture ? graph.layout_in(use.index, use.access) : VK_IMAGE_LAYOUT_UNDEFINED;
  return row;
}

using Barriers = std::vector<std::vector<Barrier>>;

// Moves the barriers of a pass to the last boundary before it, if they wait for passes before that alone.
// `waits_for`: one more than the last pass in the frame for which each pass waits.
void join_boundaries(Barriers& barriers, const std::vector<std::size_t>& waits_for) {
  std::vector<Barrier>* boundary = nullptr;
  std::size_t at = 0;
  for (std::size_t p = 0; p < barriers.size(); ++p) {
    if (barriers[p].empty()) continue;
    if (boundary && waits_for[p] <= at) {
      const std::vector<Barrier> moved = std::exchange(barriers[p], {});
      boundary->insert(boundary->end(), moved.begin(), moved.end());
    } else {
      boundary = &barriers[p];
      at = p;
    }
  }
}

}  // namespace

Barriers derive_barriers(const FrameGraph& graph, const FrameKind& kind) {
  const std::size_t texture_count = graph.textures().size();
  std::vector<State> states(texture_count + graph.buffers().size());
  Barriers result;
  std::vector<std::size_t> waits_for(graph.passes().size());

  // Two walks: the first finds the state at the end of a frame, the second starts from it.
  for (int walk = 0; walk < 2; ++walk) {
    result.assign(graph.passes().size(), {});
    // One more than the last pass so far that uses it, and that writes it or changes its layout; 0: none.
    std::vector<std::size_t> used(states.size()), written(states.size());

    for (std::size_t p = 0; p < graph.passes().size(); ++p) {
      const PassNode& pass = graph.passes()[p];
      if (!kind.has(pass.runs)) continue;
      for (const Use& use : pass.uses) {
        const std::size_t slot = use.is_texture ? use.index : texture_count + use.index;
        State& state = states[slot];
        const AccessRow scope = scope_of(graph, use, pass.kind);
        const bool first = used[slot] == 0;

        // A texture needs one even if its layout does not change: in the first frame it has none.
        const bool opens = first && use.is_texture;
        if (opens || needs_barrier(state, scope)) {
          const bool discard = opens && graph.textures()[use.index].lifetime == Lifetime::transient &&
                               !graph.stays_general(use.index);
          const bool changes = scope.written != 0 || opens || state.layout != scope.layout;
          waits_for[p] = std::max(result[p].empty() ? 0 : waits_for[p], changes ? used[slot] : written[slot]);
          if (changes) written[slot] = p + 1;
          result[p].push_back(make_barrier(use, state, scope, first, discard));
          if (opens || state.layout != scope.layout)
            state = {.write_stages = scope.stages, .layout = scope.layout};
        }

        note_use(state, scope);
        used[slot] = p + 1;
      }
    }
  }
  join_boundaries(result, waits_for);
  return result;
}

VkImageLayout final_layout(const FrameGraph& graph, TextureId id, const FrameKind& kind) {
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  for (const PassNode& pass : graph.passes())
    for (const Use& use : pass.uses)
      if (kind.has(pass.runs) && use.is_texture && use.index == id.index)
        layout = graph.layout_in(id.index, use.access);
  return layout;
}

}  // namespace dermis::frame
