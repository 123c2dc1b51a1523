// SPDX-License-Identifier: MIT
#include "passes/blur/blur.h"

#include <algorithm>
#include <cmath>

#include "frame/executor.h"
#include "passes/bindings.h"
#include "passes/blur/blur_io.h"
#include "passes/blur/kernels.h"

namespace dermis::passes {

Blur::Out Blur::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  in_ = in;
  if (!in_.target.valid()) in_.target = d.create("light", d.desc(in.light));
  d.sample(in.light);
  d.sample(in.stretch);
  d.write(in_.target);
  return {in_.target};
}

void Blur::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.compute("blur.comp");
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
  const std::vector<float> table = kernel_table();
  kernels_ = gpu::make_buffer(library.device(), "blur kernels", std::span<const float>(table), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

void Blur::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData&) const {
  const gpu::Texture& target = resources.texture(in_.target);
  Bindings()
      .add("light_in", resources.sampled(in_.light, sampler_))
      .add("stretch", resources.sampled(in_.stretch, sampler_))
      .add("Kernels", kernels_)
      .add("light_out", gpu::StorageImageBinding{&target})
      .bind(cmd, *pipeline_);
  cmd.push(*pipeline_, io::BlurIo{.variance_mm2 = static_cast<float>(settings_.variance_mm2),
                                  .axis = settings_.axis,
                                  .texel_averaged = settings_.texel_averaged ? 1u : 0u,
                                  .extent = {target.desc().width, target.desc().height}});
  cmd.dispatch_over(*pipeline_, target.desc().width, target.desc().height);
}

std::vector<BlurStep> blur_steps(const std::vector<double>& variances_mm2, double max_texels_per_mm) {
  std::vector<BlurStep> steps;
  const double first_sigma = kernel_max_sigma / max_texels_per_mm;
  double done_mm2 = 0;
  for (const double variance_mm2 : variances_mm2) {
    while (true) {
      const double reach = done_mm2 == 0 ? first_sigma * first_sigma : 4 * done_mm2;  // variance after the largest step from here
      // Below the texel everything is reached in one step: with a tap spacing of one texel no light can be skipped.
      const double dense_reach = done_mm2 + first_sigma * first_sigma;
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

std::vector<BlurStep> blur_steps(const gaussians::SumOfGaussians& profile, double max_texels_per_mm) {
  std::vector<double> variances;
  for (const gaussians::Gaussian& term : profile.terms) variances.push_back(term.variance_mm2);
  return blur_steps(variances, max_texels_per_mm);
}

int gutter_width(const gaussians::SumOfGaussians& profile, double max_texels_per_mm) {
  double widest_mm2 = 0;
  for (const BlurStep& step : blur_steps(profile, max_texels_per_mm)) widest_mm2 = std::max(widest_mm2, step.variance_mm2);
  return static_cast<int>(std::clamp(std::ceil(3 * std::sqrt(widest_mm2) * max_texels_per_mm) + 2, 3.0, 96.0));
}

}  // namespace dermis::passes
