// SPDX-License-Identifier: MIT
#include "render/techniques/published/convolution.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/targets.h"
#include "render/shared/gutters_io.h"
#include "render/techniques/published/blur_io.h"
#include "render/techniques/published/square_io.h"

namespace dermis::techniques::papers {

using passes::Bindings;

Seams::Out Seams::declare(frame::Declare& d) {
  compute(d, "published/seams.comp");
  if (settings.of_stretch) d.runs(frame::Runs::once);
  d.write(in.target);
  return {};
}

void Seams::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  if (!settings.of_stretch && !is_lit(frame, settings.object)) return;
  const std::uint32_t side =
      settings.of_stretch ? resources.texture(in.target).desc().width : used_side(frame, settings.object);

  const passes::GpuMesh& mesh = mesh_of(frame, settings.object);
  const auto found = mesh.gutters.find(side);
  if (found == mesh.gutters.end() || found->second.count == 0) return;
  Bindings()
      .add("Gutters", found->second.list)
      .add("target", resources.storage(in.target))
      .bind(cmd, pipeline());
  const io::GuttersIo io{
      .count = found->second.count, .mode = settings.of_stretch ? 1u : 0u, .origin = {}, .side = side};
  dispatch(cmd, io, io.count, 1);
}

DepthMask::Out DepthMask::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.read(in.light);
  d.depth(in.mask);
  return {};
}

void DepthMask::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.graphics({.vertex = "published/square.vert",
                                 .fragment = "published/depth_mask.frag",
                                 .depth_format = passes::depth_format,
                                 .depth_test = true,
                                 .depth_write = true,
                                 .depth_compare = VK_COMPARE_OP_ALWAYS});
}

void DepthMask::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  if (!is_lit(frame, settings.object)) return;
  Bindings().add("light", resources.storage(in.light)).bind(cmd, *pipeline_);
  const gpu::DepthTarget depth{.texture = &resources.texture(in.mask), .clear = 0.0f};
  cmd.begin_rendering_area({}, depth, used_area(frame, settings.object), true);
  cmd.draw(3);
  cmd.end_rendering();
}

Blur::Out Blur::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.colour(in.target);
  if (in.depth_mask.valid()) d.depth(in.depth_mask);
  d.read(in.light);
  d.sample(in.stretch);
  return {};
}

void Blur::prepare(gpu::PipelineLibrary& library) {
  const bool by_depth = in.depth_mask.valid();
  pipeline_ = &library.graphics({.vertex = "published/square.vert",
                                 .fragment = "published/blur.frag",
                                 .constants = {{"alpha_test", settings.alpha_test ? 1u : 0u}},
                                 .colour_formats = {passes::light_format},
                                 .depth_format = by_depth ? passes::depth_format : VK_FORMAT_UNDEFINED,
                                 .depth_test = by_depth,
                                 .depth_compare = VK_COMPARE_OP_LESS_OR_EQUAL});
  kernels_ =
      gpu::make_buffer(library.device(), "blur kernels", std::span(kernel_table()), gpu::texels_of_shaders);
}

void Blur::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  if (!is_lit(frame, settings.object)) return;
  Bindings()
      .add("light_in", resources.storage(in.light))
      .add("stretch", resources.nearest(in.stretch))
      .add("Kernels", kernels_)
      .bind(cmd, *pipeline_);
  cmd.push(*pipeline_, io::PaperBlurIo{.variance_mm2 = static_cast<float>(settings.variance_mm2),
                                       .axis = settings.axis,
                                       .texel_averaged = settings.first ? 1u : 0u,
                                       .side = used_side(frame, settings.object)});

  const gpu::ColourTarget colour{.texture = &resources.texture(in.target), .clear = passes::no_light};
  std::optional<gpu::DepthTarget> depth;
  if (in.depth_mask.valid()) depth = gpu::DepthTarget{.texture = &resources.texture(in.depth_mask)};
  cmd.begin_rendering_area(std::span(&colour, 1), depth, used_area(frame, settings.object), true);
  cmd.draw(3);
  cmd.end_rendering();
}

JoinThrough::Out JoinThrough::declare(frame::Declare& d) {
  compute(d, "published/through.comp");
  d.sample(in.light);
  d.write(in.through);
  return {};
}

void JoinThrough::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  if (!is_lit(frame, settings.object)) return;
  Bindings()
      .add("light", resources.nearest(in.light))
      .add("through", resources.storage(in.through))
      .bind(cmd, pipeline());
  const std::uint32_t side = used_side(frame, settings.object);
  dispatch(cmd, io::SquareIo{side}, side, side);
}

}  // namespace dermis::techniques::papers
