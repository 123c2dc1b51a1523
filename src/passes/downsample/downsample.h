// SPDX-License-Identifier: MIT
/// Moves light that is blurred already to a smaller map: a texel is the mean of those that it covers.
/// Based on: the "progressively smaller" maps that [JG08] sec. 2 mentions; map_halvings() decides when
#pragma once

#include <vector>

#include "gaussians/sum.h"
#include "passes/compute_pass.h"
#include "passes/light_pool.h"

namespace dermis::passes {

class Downsample : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> from, to;  ///< the same squares in the larger and in the smaller pool
    std::uint32_t next_step = 0;      ///< of the chain of blurs
    bool smoothed = false;  ///< by [1 3 3 1] / 8 where maps are halved, else by the mean; see passes/cascade/
  } settings;
  struct In {
    frame::TextureId light, stretch;
    frame::TextureId target;  ///< RGBA16F pool
    /// Of the size of `light`: read for heads that have not been blurred before `next_step`.
    frame::TextureId start;
  } in;
  struct Out {
    frame::TextureId light;
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

inline constexpr std::uint32_t max_halvings = 3;

/// Returns how often the map of each term is halved at T_max, 0 to max_halvings and never falling: as often
/// as leaves the light that it starts from, blurred by the previous term, a sigma of at least one texel (a
/// Gaussian of one texel lets 0.7 % through at the limit of sampling). The first is 0. `map_size` is T_max,
/// mean_texels_per_mm the density there; uses only halvings that divide it.
std::vector<std::uint32_t> map_halvings(const gaussians::SumOfGaussians& profile, double mean_texels_per_mm,
                                        std::uint32_t map_size);

}  // namespace dermis::passes
