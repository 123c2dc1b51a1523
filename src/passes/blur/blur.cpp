// SPDX-License-Identifier: MIT
#include "passes/blur/blur.h"

#include <algorithm>
#include <cmath>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/blur/blur_io.h"
#include "passes/kernels.h"
#include "passes/targets.h"
#include "shared/tiles_io.h"

namespace dermis::passes {

Blur::Out Blur::declare(frame::Declare& d) {
  d.kind(drawn() ? frame::PassKind::raster : frame::PassKind::compute);
  d.sample(in.light);
  if (in.start.valid()) d.sample(in.start);
  d.sample(in.stretch);
  if (drawn())
    d.colour(in.target);
  else
    d.write(in.target);
  if (settings.skip_unlit == SkipUnlit::by_depth) d.depth(in.depth_mask);
  if (settings.skip_unlit == SkipUnlit::by_tiles) {
    d.read(in.lists.tiles);
    d.read(in.lists.counts);
    d.indirect(in.lists.arguments);
  }
  return {in.target};
}

void Blur::prepare(gpu::PipelineLibrary& library) {
  const bool depth = settings.skip_unlit == SkipUnlit::by_depth;
  if (drawn())
    pipeline_ = &library.graphics(
        {.vertex = "square.vert",
         .fragment = "blur.frag",
         .constants = {{"alpha_test", settings.skip_unlit == SkipUnlit::by_alpha ? 1u : 0u}},
         .colour_formats = {light_format},
         .depth_format = depth ? depth_format : VK_FORMAT_UNDEFINED,
         .depth_test = depth,
         .depth_compare = VK_COMPARE_OP_LESS_OR_EQUAL});
  else
    pipeline_ =
        &library.compute("blur.comp", {{"tiled", settings.skip_unlit == SkipUnlit::by_tiles ? 1u : 0u}});
  const std::vector<float> table = kernel_table();
  kernels_ = gpu::make_buffer(library.device(), "blur kernels", std::span<const float>(table),
                              VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

void Blur::draw(gpu::Cmd& cmd, const frame::Resources& resources, VkRect2D area) const {
  const gpu::ColourTarget colour{.texture = &resources.texture(in.target), .clear = no_light};
  std::optional<gpu::DepthTarget> depth;
  if (settings.skip_unlit == SkipUnlit::by_depth)
    depth = gpu::DepthTarget{.texture = &resources.texture(in.depth_mask)};
  cmd.begin_rendering_area(std::span(&colour, 1), depth, area, true);
  cmd.draw(3);
  cmd.end_rendering();
}

// Returns the variance that averaging r x r texels into one has added, in texels^2 of the smaller map: that
// of r points at a distance of 1 / r.
float Blur::averaged_texels2(const FrameData& frame, const UsedSquare& square) const {
  MapSquare before = square;
  before.halvings = settings.halvings_before.value_or(square.halvings);
  const float r = static_cast<float>(used_square(frame, before).side) / static_cast<float>(square.side);
  return (1 - 1 / (r * r)) / 12;
}

// Returns whether a head enters the chain with this step.
bool Blur::enters(const FrameData& frame, const UsedSquare& square) const {
  return settings.chain && terms_of(frame, square).first_step == settings.chain->number;
}

std::vector<UsedSquare> Blur::squares_of(const FrameData& frame) const {
  return settings.chain ? blurred_squares(frame, settings.squares, settings.chain->number)
                        : used_squares(frame, settings.squares);
}

void Blur::bind(gpu::Cmd& cmd, const frame::Resources& resources, frame::TextureId light) const {
  Bindings bindings;
  bindings.add("light_in", resources.nearest(light))
      .add("stretch", resources.nearest(in.stretch))
      .add("Kernels", kernels_);

  const bool tiled = settings.skip_unlit == SkipUnlit::by_tiles;
  // Without tiles the list is never read, but a buffer must be bound.
  bindings.add("Tiles", tiled ? resources.buffer(in.lists.tiles) : kernels_)
      .add("TileCounts", tiled ? resources.buffer(in.lists.counts) : kernels_);
  if (!drawn()) bindings.add("light_out", resources.storage(in.target));
  bindings.bind(cmd, *pipeline_);
}

void Blur::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const bool tiled = settings.skip_unlit == SkipUnlit::by_tiles;
  frame::TextureId bound;

  for (const UsedSquare& square : squares_of(frame)) {
    const bool enters = this->enters(frame, square);
    const frame::TextureId light = enters && in.start.valid() ? in.start : in.light;
    if (light != bound) bind(cmd, resources, light);
    bound = light;

    const double variance_mm2 = enters ? settings.chain->total_mm2 : settings.variance_mm2;
    cmd.push(*pipeline_, io::BlurIo{.variance_mm2 = static_cast<float>(variance_mm2),
                                    .axis = settings.axis,
                                    .texel_averaged = enters || settings.texel_averaged ? 1u : 0u,
                                    .origin = square.origin,
                                    .side = square.side,
                                    .square = square.index,
                                    .first_tile = square.index * in.lists.room,
                                    .averaged_texels2 = averaged_texels2(frame, square)});

    if (drawn())
      draw(cmd, resources, square.area());
    else if (tiled)
      cmd.dispatch_indirect(resources.buffer(in.lists.arguments), square.index * sizeof(io::TileArgumentsIo));
    else
      cmd.dispatch_over(*pipeline_, square.side, square.side);
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
      // Below the size of a texel one step suffices: with a tap spacing of one texel no light can be skipped.
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

int gutter_width(const gaussians::SumOfGaussians& profile, double max_texels_per_mm, double first_mm2) {
  double widest_mm2 = first_mm2;
  for (const BlurStep& step : blur_steps(profile, max_texels_per_mm))
    widest_mm2 = std::max(widest_mm2, step.variance_mm2);
  const double reach = std::ceil(kernel_reach * std::sqrt(widest_mm2) * max_texels_per_mm) + 2;
  return static_cast<int>(std::clamp(reach, 3.0, double{max_gutter_width}));
}

}  // namespace dermis::passes
