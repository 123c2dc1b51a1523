// SPDX-License-Identifier: MIT
#include "render/passes/screen/separable_blur/separable_blur.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/screen/separable_blur/separable_blur_io.h"

namespace dermis::passes {

SeparableBlur::Out SeparableBlur::declare(frame::Declare& d) {
  DERMIS_ASSERT(!settings.kernels.empty());
  const std::size_t taps = settings.kernels.front().taps.size();
  for (const LineKernel& kernel : settings.kernels) DERMIS_ASSERT_EQ(kernel.taps.size(), taps);
  compute(d, "separable_blur.comp",
          {{"tap_count", static_cast<std::uint32_t>(taps)},
           {"axis", settings.axis},
           {"published", settings.published ? 1u : 0u}});

  const gpu::TextureDesc desc = d.desc(in.light);
  out_.light = d.create("blurred light", screen_light(desc.width, desc.height));
  d.sample(in.light);
  d.read(in.surface.depth_mm);
  d.sample(in.surface.surface);
  d.sample(in.surface.leaving);
  d.write(out_.light);
  return out_;
}

void SeparableBlur::prepare(gpu::PipelineLibrary& library) {
  ComputePass::prepare(library);
  std::vector<io::LineKernelIo> kernels;
  std::vector<io::LineTapIo> taps;
  for (const LineKernel& kernel : settings.kernels) {
    kernels.push_back({.mm_per_unit = static_cast<float>(kernel.mm_per_unit),
                       .reach_mm = static_cast<float>(kernel.reach_mm)});
    for (const auto& [offset, weight] : kernel.taps)
      taps.push_back(
          {.offset = static_cast<float>(offset), .weight = glm::vec3(weight[0], weight[1], weight[2])});
  }
  constexpr VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  kernels_ =
      gpu::make_buffer(library.device(), "line kernels", std::span<const io::LineKernelIo>(kernels), usage);
  taps_ = gpu::make_buffer(library.device(), "line taps", std::span<const io::LineTapIo>(taps), usage);
}

void SeparableBlur::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("Frame", frame.frame_io)
      .add("light", resources.linear(in.light))
      .add("depth_of_skin", resources.storage(in.surface.depth_mm))
      .add("surface_of_skin", resources.nearest(in.surface.surface))
      .add("leaving_skin", resources.nearest(in.surface.leaving))
      .add("Kernels", kernels_)
      .add("Taps", taps_)
      .add("target", resources.storage(out_.light))
      .bind(cmd, pipeline());
  const io::ScreenIo io = screen_io(resources.texture(out_.light).desc(), in.surface, frame);
  dispatch(cmd, io, io.size);
}

}  // namespace dermis::passes
