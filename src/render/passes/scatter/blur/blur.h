// SPDX-License-Identifier: MIT
/// Blurs the light stored on the skin by one Gaussian of the profile, one axis per pass, in millimetres for
/// any unwrap. Taps never cross into another chart: beside seams they read gutters. Based on: [DLE07]
/// sec. 3.3 (separable, each Gaussian from the previous one). Departures: kernels.h, blur.comp. Up to two
/// terms start from the light, and share its reads along the first axis. So does the first that a head reads
/// (render/passes/light_map/mapped_terms.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "frame/graph.h"
#include "render/passes/compute_pass.h"
#include "render/passes/light_map/light_pool.h"
#include "render/passes/light_map/tile_lists.h"
#include "tissue/gaussians/sum.h"

namespace dermis::passes {

/// The place of a step in the chain of blurs of a skin mesh. Heads enter the chain at different steps:
/// MappedTerms::first_step.
struct ChainStep {
  std::uint32_t number = 0;
  double total_mm2 = 0;  ///< variance of this step and all before: what a head that enters here blurs by
};

class Blur : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    double variance_mm2 = 0;      ///< of this step
    std::uint32_t axis = 0;       ///< 0, then 1
    bool texel_averaged = false;  ///< no blur has spread its input, which is constant over each texel
    /// Set: leaves out heads that enter the chain at a later step; those that enter here start from
    /// In::start, texel-averaged, by total_mm2. None: all heads blur by variance_mm2.
    std::optional<ChainStep> chain;
    /// Axis 0 of a step from the light: a narrower one that starts there, too, and shares its reads. Heads
    /// that enter the chain after it leave it out.
    std::optional<ChainStep> narrower;
  } settings;
  struct In {
    frame::TextureId light, stretch;
    frame::TextureId target;  ///< RGBA16F pool of the same size; tiles that are not listed hold 0
    TileLists lists;
    frame::TextureId start = {};     ///< with `chain` and axis 0: the light before any blur
    frame::TextureId narrower = {};  ///< target of `narrower`
  } in;
  struct Out {
    frame::TextureId light;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  bool enters(const FrameData& frame, const UsedSquare& square) const;
  std::vector<UsedSquare> squares_of(const FrameData& frame) const;
  void bind(gpu::Cmd& cmd, const frame::Resources& resources, frame::TextureId light,
            const gpu::Pipeline& pipeline) const;
  const gpu::Pipeline* two_terms_ = nullptr;  // with `narrower`, for heads that read both
  gpu::Buffer kernels_;
};

/// One step of the chain.
struct BlurStep {
  double variance_mm2 = 0;  ///< added by this step
  bool ends_term = false;   ///< the light after this step is a term of the sum
};

/// Returns the steps that blur by each variance in turn (narrow to wide). Sigma at most doubles per step, so
/// that the kernel's taps suffice, and the first is at most kernel_max_sigma texels where the map is densest
/// (max_texels_per_mm). Adds steps where terms are further apart.
std::vector<BlurStep> blur_steps(const std::vector<double>& variances_mm2, double max_texels_per_mm);
std::vector<BlurStep> blur_steps(std::span<const Gaussian> terms, double max_texels_per_mm);

/// Returns the taps of a step along one axis. `from_light`: it takes the light before any blur.
int blur_taps(double sigma_texels, bool from_light);

inline constexpr int max_gutter_width = 96;  ///< texels

/// Returns the texels beside a seam that a step may read, at most max_gutter_width: also one with which a
/// chain starts that leaves all terms but the widest out.
int gutter_width(const ScatterProfile& profile, double max_texels_per_mm);

}  // namespace dermis::passes
