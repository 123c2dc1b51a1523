// SPDX-License-Identifier: MIT
// Several passes of one type as one: for parts of a scene that are independent of each other. The number of
// passes and barriers of a frame is that of its steps then, however many parts it has.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "frame/graph.h"
#include "frame/resources.h"
#include "gpu/cmd.h"
#include "gpu/pipelines.h"

namespace dermis::frame {

/// Arguments of plan.add() for one pass.
template <class Pass>
struct Member {
  typename Pass::In in;
  typename Pass::Settings settings;
};

/// Runs its members one after the other without a barrier between them: what one writes no other may read or
/// write. Members that render to the same targets do so within one begin and end of rendering; their type has
///   bool draws(const Context&) const;  without it a member that does not clear is left out
///   bool clears() const;
///   void begin(gpu::Cmd&, const Resources&, const Context&, bool clear) const;
///   void draw(gpu::Cmd&, const Resources&, const Context&) const;
/// in place of record().
template <class Pass>
class Together {
 public:
  struct Settings {
  } settings;
  struct In {
    std::vector<Member<Pass>> members;  ///< at least one
  } in;
  struct Out {};

  Out declare(Declare& d) {
    DERMIS_ASSERT(!in.members.empty());
    for (Member<Pass>& member : std::exchange(in.members, {})) {
      Pass& pass = passes_.emplace_back();
      pass.in = std::move(member.in);
      pass.settings = std::move(member.settings);
      pass.declare(d);
    }
    return {};
  }

  void prepare(gpu::PipelineLibrary& library) {
    if constexpr (requires(Pass pass) { pass.prepare(library); })
      for (Pass& pass : passes_) pass.prepare(library);
  }

  template <class Context>
  void record(gpu::Cmd& cmd, const Resources& resources, const Context& context) const {
    if constexpr (requires(const Pass& pass) { pass.begin(cmd, resources, context, true); })
      render(cmd, resources, context);
    else
      for (const Pass& pass : passes_) pass.record(cmd, resources, context);
  }

 private:
  template <class Context>
  void render(gpu::Cmd& cmd, const Resources& resources, const Context& context) const {
    const bool clears = std::ranges::any_of(passes_, [](const Pass& pass) { return pass.clears(); });
    const bool draws = std::ranges::any_of(passes_, [&](const Pass& pass) { return pass.draws(context); });
    if (!clears && !draws) return;

    passes_.front().begin(cmd, resources, context, clears);
    for (const Pass& pass : passes_)
      if (pass.draws(context)) pass.draw(cmd, resources, context);
    cmd.end_rendering();
  }

  std::vector<Pass> passes_;
};

}  // namespace dermis::frame
