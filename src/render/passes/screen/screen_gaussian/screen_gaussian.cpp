// SPDX-License-Identifier: MIT
#include "render/passes/screen/screen_gaussian/screen_gaussian.h"

#include <cmath>

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/scatter/kernels.h"
#include "render/passes/screen/screen_gaussian/screen_gaussian_io.h"

namespace dermis::passes {

ScreenGaussian::Out ScreenGaussian::declare(frame::Declare& d) {
  DERMIS_ASSERT(!settings.steps.empty());
  compute(d, "screen_gaussian.comp",
          {{"radius", static_cast<std::uint32_t>(settings.radius)},
           {"axis", settings.axis},
           {"published", settings.published ? 1u : 0u},
           {"begins", settings.begins ? 1u : 0u}});
  d.sample(in.light);
  d.read(in.surface.depth_mm);
  d.read(in.surface.surface);
  d.sample(in.surface.leaving);
  d.write(in.target);
  d.write(in.sum);
  return {};
}

void ScreenGaussian::prepare(gpu::PipelineLibrary& library) {
  ComputePass::prepare(library);
  std::vector<io::GaussianStepIo> steps;
  for (const GaussianStep& step : settings.steps)
    steps.push_back({.mm_per_unit = static_cast<float>(step.mm_per_unit),
                     .reach_mm = static_cast<float>(step.reach_mm),
                     .sigma_mm = static_cast<float>(std::sqrt(step.variance_mm2)),
                     .weight = glm::vec3(step.weight[0], step.weight[1], step.weight[2])});
  constexpr VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  steps_ =
      gpu::make_buffer(library.device(), "gaussian steps", std::span<const io::GaussianStepIo>(steps), usage);
  const std::vector<float> table = gaussian_table(settings.radius);
  kernels_ = gpu::make_buffer(library.device(), "gaussian kernels", std::span<const float>(table),
                              gpu::texels_of_shaders);
}

void ScreenGaussian::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("Frame", frame.frame_io)
      .add("light", resources.linear(in.light))
      .add("depth_of_skin", resources.storage(in.surface.depth_mm))
      .add("surface_of_skin", resources.storage(in.surface.surface))
      .add("leaving_skin", resources.nearest(in.surface.leaving))
      .add("Steps", steps_)
      .add("Kernels", kernels_)
      .add("target", resources.storage(in.target))
      .add("sum_of_light", resources.storage(in.sum))
      .bind(cmd, pipeline());
  const io::ScreenIo io = screen_io(resources.texture(in.target).desc(), in.surface, frame);
  dispatch(cmd, io, io.size);
}

}  // namespace dermis::passes
