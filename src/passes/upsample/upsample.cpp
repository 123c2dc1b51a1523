// SPDX-License-Identifier: MIT
#include "passes/upsample/upsample.h"

#include <glm/gtc/type_ptr.hpp>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/upsample/upsample_io.h"

namespace dermis::passes {

Upsample::Out Upsample::declare(frame::Declare& d) {
  compute(d, "upsample.comp");
  DERMIS_ASSERT_EQ(settings.from.size(), settings.to.size());
  d.read(in.light);
  d.read(in.joining);
  d.sample(in.stretch);
  d.read(in.unspread);
  d.write(in.target);
  return {};
}

// Fills in what decides how much of the light is taken from the smaller maps.
void Upsample::fill_level(io::UpsampleIo& io, const FrameData& frame, const MapSquare& to,
                          const MappedTerms& terms) const {
  const CascadeStep& step = settings.steps[settings.step];
  std::vector<float> weights;
  for (const auto& [r, g, b] : terms.weights) weights.push_back((r + g + b) / 3);
  const std::uint32_t after = level_after(settings.steps, terms.first_step, step.halvings);
  io.level = cascade_level(settings.steps, terms.first_step, step.halvings, weights,
                           full_texels(frame, to, step.halvings), full_texels(frame, to, after),
                           full_texels(frame, to, to.halvings));

  for (std::uint32_t i = settings.step; i < settings.steps.size(); ++i)
    if (settings.steps[i].term) io.spread += glm::make_vec3(terms.weights[*settings.steps[i].term].data());
}

void Upsample::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light_in", resources.storage(in.light))
      .add("joining", resources.storage(in.joining))
      .add("light_out", resources.storage(in.target))
      .add("stretch", resources.nearest(in.stretch))
      .add("unspread", resources.storage(in.unspread))
      .bind(cmd, pipeline());

  for (std::size_t i = 0; i < settings.to.size(); ++i) {
    const MappedTerms terms = terms_of(frame, settings.to[i]);
    const bool spreads = terms.any && terms.first_step < settings.steps.size();
    if (!instance_of(frame, settings.to[i]).visible || !spreads) continue;

    const UsedSquare from = used_square(frame, settings.from[i]), to = used_square(frame, settings.to[i]);
    io::UpsampleIo io{.origin = to.origin,
                      .side = to.side,
                      .ratio = to.side / from.side,
                      .from = from.origin,
                      .joins = glm::vec3(0),
                      .spread = glm::vec3(0),
                      .level = {}};
    if (settings.joins && terms.first_step < settings.step)
      io.joins = glm::make_vec3(terms.weights[*settings.joins].data());
    if (settings.next_step) fill_level(io, frame, settings.to[i], terms);
    dispatch(cmd, io, to.side, to.side);
  }
}

}  // namespace dermis::passes
