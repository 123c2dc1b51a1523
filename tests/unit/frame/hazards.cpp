// SPDX-License-Identifier: MIT
#include "hazards.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace dermis::frame::test {
namespace {

using Stages = VkPipelineStageFlags2;
using Accesses = VkAccessFlags2;

constexpr Accesses all_writes =
    VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT;

// Vulkan 1.3, table "Supported access types": an access flag without one of its stages makes a barrier
// invalid.
Stages stages_that_may(Accesses access) {
  constexpr Stages shaders = VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                             VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  switch (access) {
    case VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT: return VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT;
    case VK_ACCESS_2_INDEX_READ_BIT: return VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT;
    case VK_ACCESS_2_SHADER_SAMPLED_READ_BIT:
    case VK_ACCESS_2_SHADER_STORAGE_READ_BIT:
    case VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT: return shaders;
    case VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT:
    case VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT: return VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    case VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT:
    case VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT:
      return VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
    case VK_ACCESS_2_TRANSFER_READ_BIT:
    case VK_ACCESS_2_TRANSFER_WRITE_BIT: return VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    default: return 0;
  }
}

template <class F>
void for_each_bit(std::uint64_t mask, F&& f) {
  for (; mask != 0; mask &= mask - 1) f(mask & (~mask + 1));
}

// What has become of one stage of something that happened: who comes surely after it, and which accesses of
// which stages see its writes.
struct Trace {
  Stages ended_by = 0;  // the stage itself; 0 for a layout change, which no stage does
  Stages after = 0;
  bool available = false;
  std::map<Stages, Accesses> visible;  // one bit of stage -> accesses
};

struct Event {
  std::string name;
  Accesses written = 0;       // by stages
  bool writes = false;        // also true of a layout change
  std::vector<Trace> traces;  // one a stage
};

bool waits_for(const Barrier& b, const Trace& t) { return ((t.ended_by | t.after) & b.source_stages) != 0; }

void carry(const Barrier& b, const Event& event, Trace& t) {
  if (!waits_for(b, t)) return;
  // A write is made available by a barrier whose first scope holds the stage and the access themselves;
  // chains do not carry accesses back.
  const Stages here = t.ended_by & b.source_stages;
  if (event.writes && here != 0 && (event.written & b.source_access) == event.written) t.available = true;
  if (t.available) for_each_bit(b.target_stages, [&](Stages s) { t.visible[s] |= b.target_access; });
  t.after |= b.target_stages;
}

// One resource through two frames.
class Walk {
 public:
  Walk(const FrameGraph& plan, bool is_texture, std::uint32_t index, std::vector<std::string>& found)
      : plan_(&plan), is_texture_(is_texture), index_(index), found_(&found) {}

  void run(const std::vector<std::vector<Barrier>>& barriers, const FrameKind& kind) {
    for (frame_ = 0; frame_ < 2; ++frame_) {
      used_in_frame_ = false;
      for (std::size_t p = 0; p < plan_->passes().size(); ++p) {
        const PassNode& pass = plan_->passes()[p];
        if (!kind.has(pass.runs)) continue;
        pass_ = &pass;
        const auto use = std::ranges::find_if(pass.uses, [&](const Use& u) { return uses_it(u); });
        for (const Barrier& b : barriers[p])
          if (b.is_texture == is_texture_ && b.index == index_) {
            if (!used_from(p, kind)) report("has a barrier that no pass waits at");
            apply(b);
          }
        if (use == pass.uses.end()) continue;
        Demand demand = demand_of(use->access, pass.kind, is_texture_);
        if (is_texture_ && use->access == Access::sampled && only_shaders(plan_->textures()[index_]))
          demand.layout = VK_IMAGE_LAYOUT_GENERAL;
        check_use(demand);
      }
    }
  }

 private:
  void report(std::string_view what) {
    const std::string& name = is_texture_ ? plan_->textures()[index_].name : plan_->buffers()[index_].name;
    found_->push_back(fmt::format("frame {}, pass '{}': '{}' {}", frame_, pass_->name, name, what));
  }

  bool uses_it(const Use& use) const { return use.is_texture == is_texture_ && use.index == index_; }

  bool used_from(std::size_t first, const FrameKind& kind) const {
    return std::any_of(plan_->passes().begin() + static_cast<std::ptrdiff_t>(first), plan_->passes().end(),
                       [&](const PassNode& pass) {
                         return kind.has(pass.runs) &&
                                std::ranges::any_of(pass.uses, [&](const Use& use) { return uses_it(use); });
                       });
  }

  bool transient() const {
    return (is_texture_ ? plan_->textures()[index_].lifetime : plan_->buffers()[index_].lifetime) ==
           Lifetime::transient;
  }

  void check_form(const Barrier& b) {
    if (b.source_stages == 0 && b.source_access != 0) report("waits for accesses of no stage");
    if (b.target_stages == 0) report("has a barrier that nobody waits at");
    for_each_bit(b.source_access, [&](Accesses a) {
      if ((stages_that_may(a) & b.source_stages) == 0)
        report("names a source access that its stages cannot do");
    });
    for_each_bit(b.target_access, [&](Accesses a) {
      if ((stages_that_may(a) & b.target_stages) == 0)
        report("names a target access that its stages cannot do");
    });
    if (!is_texture_ &&
        (b.old_layout != VK_IMAGE_LAYOUT_UNDEFINED || b.new_layout != VK_IMAGE_LAYOUT_UNDEFINED))
      report("is a buffer with a layout");
    if (b.first_use != !used_in_frame_)
      report("is not said rightly to be used for the first time in the frame");
  }

  void apply(const Barrier& b) {
    check_form(b);
    // barriers.h: in the first frame of a plan nothing has a layout yet.
    const VkImageLayout old = frame_ == 0 && b.first_use ? VK_IMAGE_LAYOUT_UNDEFINED : b.old_layout;
    const bool changes_layout = is_texture_ && old != b.new_layout;
    if (is_texture_ && old != VK_IMAGE_LAYOUT_UNDEFINED && old != layout_)
      report("is not in the layout that a barrier starts from");
    if (is_texture_ && old == VK_IMAGE_LAYOUT_UNDEFINED && (used_in_frame_ || (frame_ > 0 && !transient())))
      report("loses its contents");
    for (Event& event : past_)
      for (Trace& t : event.traces) {
        if (changes_layout && !waits_for(b, t)) report("changes layout while in use by " + event.name);
        carry(b, event, t);
        if (changes_layout && event.writes && !t.available)
          report("changes layout before there is an end to the write of " + event.name);
      }
    if (!changes_layout) return;
    layout_ = b.new_layout;
    Event change{.name = "the layout change before " + pass_->name, .writes = true};
    change.traces.push_back({.after = b.target_stages, .available = true});
    for_each_bit(b.target_stages, [&](Stages s) { change.traces.back().visible[s] = b.target_access; });
    past_.push_back(std::move(change));
  }

  void check_use(const Demand& demand) {
    if (is_texture_ && layout_ != demand.layout) report("has the wrong layout");
    for (const Event& event : past_) {
      if (!event.writes && demand.written == 0) continue;
      for (const Trace& t : event.traces) {
        if ((t.after & demand.stages) != demand.stages) report("does not wait for " + event.name);
        if (event.writes)
          for_each_bit(demand.stages, [&](Stages s) { check_visible(t, s, demand, event.name); });
      }
    }
    Event event{.name = "pass " + pass_->name, .written = demand.written, .writes = demand.written != 0};
    for_each_bit(demand.stages, [&](Stages s) { event.traces.push_back({.ended_by = s}); });
    past_.push_back(std::move(event));
    used_in_frame_ = true;
  }

  void check_visible(const Trace& t, Stages stage, const Demand& demand, const std::string& writer) {
    const auto seen = t.visible.find(stage);
    if (seen == t.visible.end() || (seen->second & demand.access) != demand.access)
      report("does not see what was written by " + writer);
  }

  const FrameGraph* plan_;
  bool is_texture_;
  std::uint32_t index_;
  std::vector<std::string>* found_;
  const PassNode* pass_ = nullptr;
  int frame_ = 0;
  bool used_in_frame_ = false;
  VkImageLayout layout_ = VK_IMAGE_LAYOUT_UNDEFINED;
  std::vector<Event> past_;
};

}  // namespace

Demand demand_of(Access access, PassKind kind, bool is_texture) {
  Demand d;
  const Stages shader = kind == PassKind::compute
                            ? VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT
                            : VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;

  switch (access) {
    case Access::sampled:
      d = {shader, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, 0, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
      break;
    case Access::storage_read:
      d = {shader, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, 0, VK_IMAGE_LAYOUT_GENERAL};
      break;
    case Access::storage_write:
      d = {shader, VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, 0,
           VK_IMAGE_LAYOUT_GENERAL};
      break;
    case Access::colour_target:
      d = {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
           VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, 0,
           VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
      break;
    case Access::depth_target:
      d = {VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
           VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, 0,
           VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL};
      break;
    case Access::copy_source:
      d = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, 0,
           VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
      break;
    case Access::copy_target:
      d = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, 0,
           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
      break;
    case Access::indirect_arguments:
      d = {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, 0,
           VK_IMAGE_LAYOUT_UNDEFINED};
      break;
    case Access::indices:
      d = {VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT, VK_ACCESS_2_INDEX_READ_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED};
      break;
  }

  d.written = d.access & all_writes;
  if (!is_texture) d.layout = VK_IMAGE_LAYOUT_UNDEFINED;
  return d;
}

bool only_shaders(const TextureNode& texture) {
  constexpr VkImageUsageFlags others = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                       VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT |
                                       VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  return texture.lifetime == Lifetime::transient && (texture.desc.usage & others) == 0;
}

std::string name_of(const FrameKind& kind) {
  std::string name = "a frame";
  if (kind.first) name += ", the first";
  if (kind.changed) name += ", of changed inputs";
  if (kind.statistics) name += ", with statistics";
  return name;
}

std::vector<std::string> hazards(const FrameGraph& plan, const std::vector<std::vector<Barrier>>& barriers,
                                 const FrameKind& kind) {
  std::vector<std::string> found;
  if (barriers.size() != plan.passes().size()) return {"there is not one list of barriers a pass"};
  for (std::size_t p = 0; p < barriers.size(); ++p)
    if (!kind.has(plan.passes()[p].runs) && !barriers[p].empty())
      found.push_back(fmt::format("pass '{}' is left out but has barriers", plan.passes()[p].name));
  for (std::uint32_t t = 0; t < plan.textures().size(); ++t) Walk(plan, true, t, found).run(barriers, kind);
  for (std::uint32_t b = 0; b < plan.buffers().size(); ++b) Walk(plan, false, b, found).run(barriers, kind);
  return found;
}

}  // namespace dermis::frame::test
