// SPDX-License-Identifier: MIT
#include "passes/cascade/cascade.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/cascade/cascade_io.h"
#include "passes/kernels.h"
#include "passes/targets.h"
#include "shared/tiles_io.h"

namespace dermis::passes {
namespace {

glm::vec3 vec3_of(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

// Returns whether CascadeSum does the second axis of a step, where it is the last.
bool ends_in_sum(const CascadeStep& step) { return step.halvings == 0; }

}  // namespace

void MaskedPass::declare_target(frame::Declare& d, const Mask& mask, frame::TextureId target) {
  mask_ = mask;
  target_ = target;
  d.kind(drawn() ? frame::PassKind::raster : frame::PassKind::compute);
  if (drawn())
    d.colour(target);
  else
    d.write(target);
  if (mask.skip_unlit == SkipUnlit::by_depth) d.depth(mask.depth_mask);
  if (tiled()) {
    d.read(mask.lists.tiles);
    d.read(mask.lists.counts);
    d.indirect(mask.lists.arguments);
  }
}

void MaskedPass::make_pipeline(gpu::PipelineLibrary& library, const std::string& name) {
  const bool depth = mask_.skip_unlit == SkipUnlit::by_depth;
  if (drawn())
    pipeline_ =
        &library.graphics({.vertex = "square.vert",
                           .fragment = name + ".frag",
                           .constants = {{"alpha_test", mask_.skip_unlit == SkipUnlit::by_alpha ? 1u : 0u}},
                           .colour_formats = {light_format},
                           .depth_format = depth ? depth_format : VK_FORMAT_UNDEFINED,
                           .depth_test = depth,
                           .depth_compare = VK_COMPARE_OP_LESS_OR_EQUAL});
  else
    pipeline_ = &library.compute(name + ".comp", {{"tiled", tiled() ? 1u : 0u}});

  const std::vector<float> table = ratio_table();
  ratios_ = gpu::make_buffer(library.device(), "cascade kernels", std::span<const float>(table),
                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

void MaskedPass::offer(Bindings& bindings, const frame::Resources& resources) const {
  // Without tiles the list is never read, but a buffer must be bound.
  bindings.add("Ratios", ratios_)
      .add("Tiles", tiled() ? resources.buffer(mask_.lists.tiles) : ratios_)
      .add("TileCounts", tiled() ? resources.buffer(mask_.lists.counts) : ratios_);
  if (!drawn()) bindings.add("light_out", resources.storage(target_));
}

template <class Io>
void MaskedPass::run(gpu::Cmd& cmd, const frame::Resources& resources, const UsedSquare& square,
                     Io io) const {
  io.origin = square.origin;
  io.side = square.side;
  io.square = square.index;
  io.first_tile = square.index * mask_.lists.room;
  cmd.push(*pipeline_, io);

  if (drawn()) {
    const gpu::ColourTarget colour{.texture = &resources.texture(target_), .clear = no_light};
    std::optional<gpu::DepthTarget> depth;
    if (mask_.skip_unlit == SkipUnlit::by_depth)
      depth = gpu::DepthTarget{.texture = &resources.texture(mask_.depth_mask)};
    cmd.begin_rendering_area(std::span(&colour, 1), depth, square.area(), true);
    cmd.draw(3);
    cmd.end_rendering();
  } else if (tiled()) {
    cmd.dispatch_indirect(resources.buffer(mask_.lists.arguments),
                          square.index * sizeof(io::TileArgumentsIo));
  } else {
    cmd.dispatch_over(*pipeline_, square.side, square.side);
  }
}

CascadeBlur::Out CascadeBlur::declare(frame::Declare& d) {
  declare_target(d, in.mask, in.target);
  d.sample(in.light);
  d.sample(in.stretch);
  if (settings.joins) d.sample(in.joining);
  return {};
}

void CascadeBlur::prepare(gpu::PipelineLibrary& library) { make_pipeline(library, "cascade_blur"); }

void CascadeBlur::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings bindings;
  bindings.add("light_in", resources.nearest(in.light))
      .add("stretch", resources.nearest(in.stretch))
      .add("joining", resources.nearest(settings.joins ? in.joining : in.light));
  offer(bindings, resources);
  bindings.bind(cmd, pipeline());

  const CascadeStep& step = settings.steps[settings.number];
  for (const UsedSquare& square : blurred_squares(frame, settings.squares, settings.number)) {
    const MappedTerms terms = terms_of(frame, square);
    const bool last = terms.first_step == settings.number;
    if (last && settings.axis == 1 && ends_in_sum(step)) continue;

    // What a step takes off depends on what narrower terms of its level have taken off.
    const double ratio = full_texels(frame, square, step.halvings);
    const std::uint32_t before = terms_before(settings.steps, terms.first_step, settings.number);
    const std::uint32_t after = level_after(settings.steps, terms.first_step, step.halvings);
    const std::vector<float> no_weights(MOST_TERMS, 0);

    io::CascadeIo io{.variance_mm2 = static_cast<float>(last ? step.total_mm2 : step.variance_mm2),
                     .axis = settings.axis,
                     .texel_averaged = last && ratio == 1 ? 1u : 0u,
                     .origin = {},
                     .side = 0,
                     .square = 0,
                     .first_tile = 0,
                     .scale = glm::vec3(1),
                     .joins = glm::vec3(0),
                     .level = cascade_level(settings.steps, terms.first_step, step.halvings, no_weights,
                                            ratio, full_texels(frame, square, after), ratio),
                     .terms_before = before,
                     .share = static_cast<float>(last ? step.share_done : step.share)};
    if (settings.scales) io.scale = vec3_of(terms.weights[*settings.scales]);
    if (settings.joins && !last) io.joins = vec3_of(terms.weights[*settings.joins]);
    run(cmd, resources, square, io);
  }
}

CascadeSum::Out CascadeSum::declare(frame::Declare& d) {
  declare_target(d, in.mask, in.target);
  d.sample(in.light);
  d.sample(in.stretch);
  if (in.wide.valid()) d.sample(in.wide);
  if (in.across.valid()) d.sample(in.across);
  if (in.second.valid()) d.sample(in.second);
  return {};
}

void CascadeSum::prepare(gpu::PipelineLibrary& library) { make_pipeline(library, "cascade_sum"); }

void CascadeSum::bind(gpu::Cmd& cmd, const frame::Resources& resources, frame::TextureId light) const {
  Bindings bindings;
  bindings.add("light_in", resources.nearest(light))
      .add("stretch", resources.nearest(in.stretch))
      .add("unspread", resources.nearest(in.light))
      .add("second_group", resources.nearest(in.second.valid() ? in.second : in.light));
  offer(bindings, resources);
  bindings.bind(cmd, pipeline());
}

void CascadeSum::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  frame::TextureId bound;
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const MappedTerms terms = terms_of(frame, square);
    io::CascadeSumIo io{};
    io.spread = terms.first_step < settings.steps.size() ? 1u : 0u;

    // The second axis of the last step, if it has been left to this pass.
    frame::TextureId light = io.spread != 0 ? in.wide : in.light;
    if (io.spread != 0 && ends_in_sum(settings.steps[terms.first_step])) {
      const CascadeStep& step = settings.steps[terms.first_step];
      light = in.across;
      io.last_step_mm2 = static_cast<float>(step.total_mm2);
      io.scale = glm::vec3(1);
      if (terms.first_step + 1 == settings.steps.size()) io.scale = vec3_of(terms.weights[*step.term]);
    }
    if (light != bound) bind(cmd, resources, light);
    bound = light;

    for (std::uint32_t i = 0; i < terms.first_wide; ++i) {
      const glm::vec3 weight = vec3_of(terms.weights[i]);
      if (weight == glm::vec3(0)) continue;
      DERMIS_ASSERT_LT(io.count, std::uint32_t{MOST_NARROW});
      io.variance_mm2[io.count] = static_cast<float>(settings.variances_mm2[i]);
      io.weights[io.count++] = weight;
      if (in.second.valid() && i >= settings.second_group) io.joined += weight;
    }
    run(cmd, resources, square, io);
  }
}

}  // namespace dermis::passes
