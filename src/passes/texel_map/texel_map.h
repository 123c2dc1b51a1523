// SPDX-License-Identifier: MIT
/// Draws which triangle each texel of a light map shows, for passes that compute what is there.
#pragma once

#include <vector>

#include "passes/compute_pass.h"
#include "passes/light_pool.h"
#include "passes/texel_maps.h"

namespace dermis::passes {

/// Finds the squares whose texel map is of another T, or of another unwrap.
class StaleTexels : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    std::vector<std::uint32_t> unwraps;  ///< number of the unwrap, by skin mesh of the plan
  } settings;
  struct In {
    TexelMaps maps;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Draws those.
class TexelMap {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  } settings;
  struct In {
    TexelMaps maps;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
