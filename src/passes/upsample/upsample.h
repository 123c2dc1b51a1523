// SPDX-License-Identifier: MIT
/// Moves blurred light to a map of twice the side, where light of the next narrower Gaussian joins.
/// Based on: Burt, Adelson: The Laplacian pyramid as a compact image code. IEEE Trans. Comm. 31, 1983
#pragma once

#include <optional>
#include <vector>

#include "passes/compute_pass.h"
#include "passes/light_pool.h"

namespace dermis::passes {

class Upsample : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> from, to;  ///< the same squares in the smaller and in the larger pool
    /// The number of the step whose light this is; heads without it (MappedTerms::first_step) are left out.
    std::uint32_t step = 0;
    std::optional<std::uint32_t> joins{};  ///< the term of the next step, of heads that take that step
  } settings;
  struct In {
    frame::TextureId light;
    frame::TextureId joining;  ///< light that has not spread, of the larger size
    frame::TextureId target;   ///< RGBA16F pool
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
