// SPDX-License-Identifier: MIT
#include "passes/cascade/cascade.h"

#include <glm/gtc/type_ptr.hpp>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/cascade/cascade_io.h"
#include "passes/kernels.h"

namespace dermis::passes {
namespace {

// Returns whether CascadeSum does the second axis of a step, where it is the last.
bool ends_in_sum(const CascadeStep& step) { return step.halvings == 0; }

gpu::Buffer kernels_on(gpu::Device& device) {
  return gpu::make_buffer(device, "cascade kernels", std::span(ratio_table()), gpu::texels_of_shaders);
}

}  // namespace

CascadeBlur::Out CascadeBlur::declare(frame::Declare& d) {
  tiled(d, "cascade_blur.comp", in.lit, in.target);
  d.read(in.light);
  d.sample(in.stretch);
  if (settings.joins) d.read(in.joining);
  return {};
}

void CascadeBlur::prepare(gpu::PipelineLibrary& library) {
  TiledPass::prepare(library);
  ratios_ = kernels_on(library.device());
}

void CascadeBlur::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings bindings;
  bindings.add("light_in", resources.storage(in.light))
      .add("stretch", resources.nearest(in.stretch))
      .add("joining", resources.storage(settings.joins ? in.joining : in.light));
  bindings.add("Ratios", ratios_);
  offer(bindings, resources, ratios_);
  bindings.bind(cmd, pipeline());

  const CascadeStep& step = settings.steps[settings.number];
  const std::vector<float> no_weights(MOST_TERMS, 0);
  for (const UsedSquare& square : blurred_squares(frame, settings.squares, settings.number)) {
    const MappedTerms terms = terms_of(frame, square);
    const bool last = terms.first_step == settings.number;
    if (last && settings.axis == 1 && ends_in_sum(step)) continue;

    // What a step takes off depends on what narrower terms of its level have taken off.
    const double ratio = full_texels(frame, square, step.halvings);
    const std::uint32_t before = terms_before(settings.steps, terms.first_step, settings.number);
    const std::uint32_t after = level_after(settings.steps, terms.first_step, step.halvings);

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
    if (settings.scales) io.scale = glm::make_vec3(terms.weights[*settings.scales].data());
    if (settings.joins && !last) io.joins = glm::make_vec3(terms.weights[*settings.joins].data());
    run(cmd, resources, square, io);
  }
}

CascadeSum::Out CascadeSum::declare(frame::Declare& d) {
  tiled(d, "cascade_sum.comp", in.lit, in.target);
  d.read(in.light);
  d.sample(in.stretch);
  if (in.wide.valid()) d.read(in.wide);
  if (in.across.valid()) d.read(in.across);
  if (in.second.valid()) d.read(in.second);
  return {};
}

void CascadeSum::prepare(gpu::PipelineLibrary& library) {
  TiledPass::prepare(library);
  ratios_ = kernels_on(library.device());
}

void CascadeSum::bind(gpu::Cmd& cmd, const frame::Resources& resources, frame::TextureId light) const {
  Bindings bindings;
  bindings.add("light_in", resources.storage(light))
      .add("stretch", resources.nearest(in.stretch))
      .add("unspread", resources.storage(in.light))
      .add("second_group", resources.storage(in.second.valid() ? in.second : in.light));
  bindings.add("Ratios", ratios_);
  offer(bindings, resources, ratios_);
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
      if (terms.first_step + 1 == settings.steps.size())
        io.scale = glm::make_vec3(terms.weights[*step.term].data());
    }
    if (light != bound) bind(cmd, resources, light);
    bound = light;

    for (std::uint32_t i = 0; i < terms.first_wide; ++i) {
      const glm::vec3 weight = glm::make_vec3(terms.weights[i].data());
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
