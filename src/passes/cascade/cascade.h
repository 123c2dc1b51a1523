// SPDX-License-Identifier: MIT
/// Spreads the light of the skin from wide to narrow: the light of the widest Gaussian first, on the smallest
/// map; then the light of the next joins what has been blurred, and both are blurred by the rest. One map
/// holds the sum. Based on: Burt: Fast filter transforms for image processing. CGIP 16, 1981 (Gaussians on a
/// pyramid);
///   passes/blur/ (a Gaussian on a stretched and sheared chart)
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "frame/graph.h"
#include "passes/cascade_steps.h"
#include "passes/tiled_pass.h"

namespace dermis::passes {

/// One axis of one step. Of a head's last step, on maps that are not halved, CascadeSum does the second.
class CascadeBlur : public TiledPass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    std::vector<CascadeStep> steps;  ///< of the cascade
    /// Of the step among them. Heads whose MappedTerms::first_step is a later one are left out.
    std::uint32_t number = 0;
    std::uint32_t axis = 0;                 ///< 0, then 1
    std::optional<std::uint32_t> scales{};  ///< axis 1: the widest term, whose weight multiplies the result
    /// axis 1: the term of the next step, if its maps have the same size; its light joins at the end, of
    /// heads that take that step.
    std::optional<std::uint32_t> joins{};
  } settings;
  struct In {
    frame::TextureId light, stretch;
    frame::TextureId target;        ///< RGBA16F pool of the same size
    TileLists lit = {};             ///< tiles that hold light; none: the whole square
    frame::TextureId joining = {};  ///< with `joins`: light that has not spread
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  gpu::Buffer ratios_;
};

/// Adds the narrow terms to what the wide ones have spread.
class CascadeSum : public TiledPass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;     ///< not halved
    std::vector<double> variances_mm2;  ///< of all terms
    std::vector<CascadeStep> steps;
    std::uint32_t second_group = ~0u;  ///< first term of the second group of transmitted light
  } settings;
  struct In {
    frame::TextureId light;  ///< that has not spread
    frame::TextureId stretch;
    frame::TextureId target;
    TileLists lit = {};          ///< tiles that hold light; none: the whole square
    frame::TextureId wide = {};  ///< with `steps`: light that has moved here after the last step
    frame::TextureId across =
        {};  ///< with `steps`: light after the first axis of the last step, if that is here
    frame::TextureId second = {};  ///< with `second_group`: light that has not spread, of that group
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void bind(gpu::Cmd& cmd, const frame::Resources& resources, frame::TextureId light) const;
  gpu::Buffer ratios_;
};

}  // namespace dermis::passes
