// SPDX-License-Identifier: MIT
#include "render/passes/scatter/blur/blur.h"

#include <algorithm>
#include <cmath>

#include "base/core/assert.h"
#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/scatter/blur/blur_io.h"
#include "render/passes/scatter/kernels.h"
#include "render/shared/tiles_io.h"

namespace dermis::passes {

Blur::Out Blur::declare(frame::Declare& d) {
  DERMIS_ASSERT_EQ(in.narrower.valid(), settings.narrower.has_value());
  compute(d, "blur.comp", {{"two_terms", 0u}});
  d.read(in.light);
  d.write(in.target);
  if (in.narrower.valid()) d.write(in.narrower);
  d.read(in.lists.tiles);
  d.read(in.lists.counts);
  d.indirect(in.lists.arguments);
  if (in.start.valid()) d.read(in.start);
  d.sample(in.stretch);
  return {in.target};
}

void Blur::prepare(gpu::PipelineLibrary& library) {
  ComputePass::prepare(library);
  if (settings.narrower) two_terms_ = &library.compute("blur.comp", {{"two_terms", 1u}});
  kernels_ =
      gpu::make_buffer(library.device(), "blur kernels", std::span(kernel_table()), gpu::texels_of_shaders);
}

// Returns whether a head enters the chain with this step.
bool Blur::enters(const FrameData& frame, const UsedSquare& square) const {
  return settings.chain && terms_of(frame, square).first_step == settings.chain->number;
}

std::vector<UsedSquare> Blur::squares_of(const FrameData& frame) const {
  return settings.chain ? blurred_squares(frame, settings.squares, settings.chain->number)
                        : used_squares(frame, settings.squares);
}

void Blur::bind(gpu::Cmd& cmd, const frame::Resources& resources, frame::TextureId light,
                const gpu::Pipeline& pipeline) const {
  Bindings()
      .add("light_in", resources.storage(light))
      .add("stretch", resources.nearest(in.stretch))
      .add("Kernels", kernels_)
      .add("light_out", resources.storage(in.target))
      .add("narrower_out", resources.storage(in.narrower.valid() ? in.narrower : in.target))
      .add("Tiles", resources.buffer(in.lists.tiles))
      .add("TileCounts", resources.buffer(in.lists.counts))
      .bind(cmd, pipeline);
}

void Blur::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  frame::TextureId bound;
  const gpu::Pipeline* bound_pipeline = nullptr;

  for (const UsedSquare& square : squares_of(frame)) {
    const bool enters = this->enters(frame, square);
    const frame::TextureId light = enters && in.start.valid() ? in.start : in.light;
    const bool narrower =
        settings.narrower && terms_of(frame, square).first_step <= settings.narrower->number;
    const gpu::Pipeline& pipeline = narrower ? *two_terms_ : this->pipeline();
    if (light != bound || &pipeline != bound_pipeline) bind(cmd, resources, light, pipeline);
    bound = light;
    bound_pipeline = &pipeline;

    const double variance_mm2 = enters ? settings.chain->total_mm2 : settings.variance_mm2;
    const std::uint32_t list = in.lists.to_blur(square);
    cmd.push(pipeline,
             io::BlurIo{.variance_mm2 = static_cast<float>(variance_mm2),
                        .narrower_mm2 = narrower ? static_cast<float>(settings.narrower->total_mm2) : 0.0f,
                        .axis = settings.axis,
                        .texel_averaged = enters || settings.texel_averaged ? 1u : 0u,
                        .origin = square.origin,
                        .side = square.side,
                        .list = list,
                        .room = in.lists.room});
    cmd.dispatch_indirect(resources.buffer(in.lists.arguments), list * sizeof(io::TileArgumentsIo));
  }
}

std::vector<BlurStep> blur_steps(const std::vector<double>& variances_mm2, double max_texels_per_mm) {
  std::vector<BlurStep> steps;
  const double first_sigma = kernel_max_sigma / max_texels_per_mm,
               dense_sigma = spaced_max_sigma / max_texels_per_mm;
  double done_mm2 = 0;

  for (const double variance_mm2 : variances_mm2) {
    while (true) {
      // variance after the largest step from here
      const double reach = done_mm2 == 0 ? first_sigma * first_sigma : 4 * done_mm2;
      // Below the size of a texel one step suffices: with a tap spacing of one texel no light can be skipped.
      const double dense_reach = done_mm2 + dense_sigma * dense_sigma;
      const double limit = std::max(reach, dense_reach);
      if (variance_mm2 <= limit * (1 + 1e-9)) break;
      steps.push_back({.variance_mm2 = limit - done_mm2, .ends_term = false});
      done_mm2 = limit;
    }

    steps.push_back({.variance_mm2 = variance_mm2 - done_mm2, .ends_term = true});
    done_mm2 = variance_mm2;
  }

  return steps;
}

std::vector<BlurStep> blur_steps(std::span<const Gaussian> terms, double max_texels_per_mm) {
  std::vector<double> variances;
  for (const Gaussian& term : terms) variances.push_back(term.variance_mm2);
  return blur_steps(variances, max_texels_per_mm);
}

int blur_taps(double sigma_texels, bool from_light) {
  const double spacing =
      std::max(std::ceil(sigma_texels / (from_light ? kernel_max_sigma : spaced_max_sigma)), 1.0);
  return 2 * reach_of(sigma_texels / spacing) + 1;
}

int gutter_width(const ScatterProfile& profile, double max_texels_per_mm) {
  const double widest_mm = std::sqrt(profile.max_variance_mm2());
  const double reach = std::ceil(kernel_reach * widest_mm * max_texels_per_mm) + 2;
  return static_cast<int>(std::clamp(reach, 3.0, double{max_gutter_width}));
}

}  // namespace dermis::passes
