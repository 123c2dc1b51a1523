// SPDX-License-Identifier: MIT
#include "passes/blur/blur.h"

#include <algorithm>
#include <cmath>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/blur/blur_io.h"
#include "passes/blur/kernels.h"
#include "shared/tiles_io.h"

namespace dermis::passes {

Blur::Out Blur::declare(frame::Declare& d, const In& in) {
  d.kind(drawn() ? frame::PassKind::raster : frame::PassKind::compute);
  in_ = in;
  d.sample(in.light);
  d.sample(in.stretch);
  if (drawn())
    d.colour(in.target);
  else
    d.write(in.target);
  if (settings_.mask == Mask::depth) d.depth(in.depth_mask);
  if (settings_.mask == Mask::tiles) {
    d.read(in.lists.tiles);
    d.read(in.lists.counts);
    d.indirect(in.lists.arguments);
  }
  return {in.target};
}

void Blur::prepare(gpu::PipelineLibrary& library) {
  const bool depth = settings_.mask == Mask::depth;
  if (drawn())
    pipeline_ = &library.graphics({.vertex = "square.vert",
                                   .fragment = "blur.frag",
                                   .constants = {{"alpha_test", settings_.mask == Mask::alpha ? 1u : 0u}},
                                   .colour_formats = {VK_FORMAT_R16G16B16A16_SFLOAT},
                                   .depth_format = depth ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_UNDEFINED,
                                   .depth_test = depth,
                                   .depth_compare = VK_COMPARE_OP_LESS_OR_EQUAL});
  else
    pipeline_ = &library.compute("blur.comp", {{"tiled", settings_.mask == Mask::tiles ? 1u : 0u}});
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
  const std::vector<float> table = kernel_table();
  kernels_ = gpu::make_buffer(library.device(), "blur kernels", std::span<const float>(table),
                              VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

void Blur::draw(gpu::Cmd& cmd, const frame::Resources& resources, VkRect2D area) const {
  const gpu::ColourTarget colour{.texture = &resources.texture(in_.target),
                                 .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}};
  std::optional<gpu::DepthTarget> depth;
  if (settings_.mask == Mask::depth) depth = gpu::DepthTarget{.texture = &resources.texture(in_.depth_mask)};
  cmd.begin_rendering_area(std::span(&colour, 1), depth, area, true);
  cmd.draw(3);
  cmd.end_rendering();
}

// What averaging r x r texels into one has already added to the variance, in texels of the smaller map: that
// of r points, one r-th apart.
float Blur::averaged_texels2(const FrameData& frame, const MapSquare& square) const {
  MapSquare before = square;
  before.halvings = settings_.halvings_before.value_or(square.halvings);
  const float r = static_cast<float>(side_of(frame, before)) / static_cast<float>(side_of(frame, square));
  return (1 - 1 / (r * r)) / 12;
}

void Blur::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings bindings;
  bindings.add("light_in", resources.sampled(in_.light, sampler_))
      .add("stretch", resources.sampled(in_.stretch, sampler_))
      .add("Kernels", kernels_);

  const bool tiled = settings_.mask == Mask::tiles;
  // Without tiles the list is never read, but must be bound: any buffer serves.
  bindings.add("Tiles", tiled ? resources.buffer(in_.lists.tiles) : kernels_)
      .add("TileCounts", tiled ? resources.buffer(in_.lists.counts) : kernels_);
  if (!drawn()) bindings.add("light_out", gpu::StorageImageBinding{&resources.texture(in_.target)});
  bindings.bind(cmd, *pipeline_);

  for (const MapSquare& square : settings_.squares) {
    if (!instance_of(frame, square).visible) continue;
    const std::uint32_t side = side_of(frame, square);
    cmd.push(*pipeline_, io::BlurIo{.variance_mm2 = static_cast<float>(settings_.variance_mm2),
                                    .axis = settings_.axis,
                                    .texel_averaged = settings_.texel_averaged ? 1u : 0u,
                                    .origin = square.origin,
                                    .side = side,
                                    .square = square.index,
                                    .first_tile = square.index * in_.lists.room,
                                    .averaged_texels2 = averaged_texels2(frame, square)});

    if (drawn())
      draw(cmd, resources, used_area(frame, square));
    else if (tiled)
      cmd.dispatch_indirect(resources.buffer(in_.lists.arguments),
                            square.index * sizeof(io::TileArgumentsIo));
    else
      cmd.dispatch_over(*pipeline_, side, side);
  }
}

std::vector<BlurStep> blur_steps(const std::vector<double>& variances_mm2, double max_texels_per_mm) {
  std::vector<BlurStep> steps;
  const double first_sigma = kernel_max_sigma / max_texels_per_mm;
  double done_mm2 = 0;

  for (const double variance_mm2 : variances_mm2) {
    while (true) {
      // variance after the largest step from here
      const double reach = done_mm2 == 0 ? first_sigma * first_sigma : 4 * done_mm2;
      // Below the texel everything is reached in one step: with a tap spacing of one texel no light can be
      // skipped.
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
  for (const BlurStep& step : blur_steps(profile, max_texels_per_mm))
    widest_mm2 = std::max(widest_mm2, step.variance_mm2);
  return static_cast<int>(
      std::clamp(std::ceil(3 * std::sqrt(widest_mm2) * max_texels_per_mm) + 2, 3.0, 96.0));
}

}  // namespace dermis::passes
