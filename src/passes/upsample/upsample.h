// SPDX-License-Identifier: MIT
/// Moves blurred light to a map of twice the side, where light of the next narrower Gaussian joins.
/// Based on: Burt, Adelson: The Laplacian pyramid as a compact image code. IEEE Trans. Comm. 31, 1983
#pragma once

#include <optional>
#include <vector>

#include "passes/cascade_steps.h"
#include "passes/compute_pass.h"
#include "passes/light_pool.h"
#include "passes/upsample/upsample_io.h"

namespace dermis::passes {

class Upsample : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> from, to;  ///< the same squares in the smaller and in the larger pool
    std::vector<CascadeStep> steps;   ///< of the cascade
    /// The number of the step whose light this is. Heads without wide terms are left out.
    std::uint32_t step = 0;
    /// The next step is on these maps, or they are the largest: texels on which the smaller maps blur too
    /// much take a part of the light from `unspread`.
    bool next_step = false;
    std::optional<std::uint32_t> joins{};  ///< the term of the next step, of heads that take that step
  } settings;
  struct In {
    frame::TextureId light;
    frame::TextureId joining;  ///< light that has not spread, of the larger size
    frame::TextureId target;   ///< RGBA16F pool
    frame::TextureId stretch;
    frame::TextureId unspread;  ///< light of the terms of `step` that has not spread, of the larger size
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void fill_level(io::UpsampleIo& io, const FrameData& frame, const MapSquare& to,
                  const MappedTerms& terms) const;
};

}  // namespace dermis::passes
