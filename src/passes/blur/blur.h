// SPDX-License-Identifier: MIT
/// Blurs the light stored on the skin by one Gaussian of the profile, one axis per pass.
/// Based on: [DLE07] sec. 3.3 (separable, each Gaussian from the previous one). Departures: kernels.h,
///   blur.comp
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "frame/graph.h"
#include "gaussians/sum.h"
#include "passes/light_pool.h"
#include "passes/tile_lists.h"

namespace dermis::passes {

class Blur {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    double variance_mm2 = 0;      ///< of this step
    std::uint32_t axis = 0;       ///< 0, then 1
    bool texel_averaged = false;  ///< the first step: its input is constant over each texel
    SkipUnlit skip_unlit = SkipUnlit::never;
    /// the first step after Downsample: halvings of the map that Downsample has read
    std::optional<std::uint32_t> halvings_before;
  } settings;
  struct In {
    frame::TextureId light, stretch;
    frame::TextureId target;           ///< RGBA16F pool of the same size
    TileLists lists = {};              ///< with SkipUnlit::by_tiles
    frame::TextureId depth_mask = {};  ///< with SkipUnlit::by_depth
  } in;
  struct Out {
    frame::TextureId light;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  bool drawn() const {
    return settings.skip_unlit != SkipUnlit::never && settings.skip_unlit != SkipUnlit::by_tiles;
  }
  void draw(gpu::Cmd& cmd, const frame::Resources& resources, VkRect2D area) const;
  float averaged_texels2(const FrameData& frame, const UsedSquare& square) const;
  const gpu::Pipeline* pipeline_ = nullptr;
  gpu::Buffer kernels_;
};

/// One step of the cascade.
struct BlurStep {
  double variance_mm2 = 0;  ///< added by this step
  bool ends_term = false;   ///< the light after this step is a term of the sum
};

/// Returns the steps that blur by each variance in turn (narrow to wide). Sigma at most doubles per step, so
/// that the kernel's taps suffice, and the first is at most kernel_max_sigma texels where the map is densest
/// (max_texels_per_mm). Adds steps where terms are further apart.
std::vector<BlurStep> blur_steps(const std::vector<double>& variances_mm2, double max_texels_per_mm);
std::vector<BlurStep> blur_steps(const gaussians::SumOfGaussians& profile, double max_texels_per_mm);

inline constexpr int max_gutter_width = 96;  ///< texels

/// Returns the texels beside a seam that the widest step reads, at most max_gutter_width.
int gutter_width(const gaussians::SumOfGaussians& profile, double max_texels_per_mm);

}  // namespace dermis::passes
