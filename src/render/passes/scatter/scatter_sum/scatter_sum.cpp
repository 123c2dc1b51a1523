// SPDX-License-Identifier: MIT
#include "render/passes/scatter/scatter_sum/scatter_sum.h"

#include <algorithm>
#include <array>
#include <span>

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/scatter/scatter_sum/scatter_sum_io.h"

namespace dermis::passes {

ScatterSum::Out ScatterSum::declare(frame::Declare& d) {
  DERMIS_ASSERT_EQ(in.lights.size(), settings.terms.size());
  DERMIS_ASSERT_LE(in.lights.size(), std::size_t{MOST_TERMS});
  compute(
      d, "scatter_sum.comp",
      {{"term_count", static_cast<std::uint32_t>(in.lights.size())}, {"mixed", settings.mixes ? 1u : 0u}});
  for (const frame::TextureId light : in.lights) d.sample(light);
  d.sample(in.stretch);
  d.write(in.sum);
  return {in.sum};
}

void ScatterSum::prepare(gpu::PipelineLibrary& library) {
  ComputePass::prepare(library);
  io::SummedTermsIo terms{};
  for (std::size_t i = 0; i < settings.terms.size(); ++i) {
    terms.weights[i] = settings.terms[i].weight;
    terms.sigma_mm[i] = settings.terms[i].sigma_mm;
  }
  terms_ = gpu::make_buffer(library.device(), "summed terms", std::span<const io::SummedTermsIo>(&terms, 1),
                            VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
}

void ScatterSum::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  if (!holds_light(frame, settings.square)) return;
  const Head& head = head_of(frame, settings.square);
  const MappedTerms mapped = terms_of(frame, settings.square);
  const UsedSquare square = used_square(frame, settings.square);
  const MapPlace& place = head.map_places[mesh_in_asset(frame, settings.square)];

  io::ScatterSumIo io{.shares = {},
                      .origin = square.origin,
                      .side = square.side,
                      .layer = layer_of(place.batch),
                      .shown_mm = mapped.shown_mm};
  std::copy_n(mapped.shares.begin(), settings.terms.size(), io.shares);

  static constexpr std::array names{"light_0", "light_1", "light_2", "light_3",
                                    "light_4", "light_5", "light_6", "light_7"};
  Bindings bindings;
  for (std::size_t i = 0; i < names.size(); ++i)
    bindings.add(names[i], resources.linear(in.lights[i < in.lights.size() ? i : 0]));
  const bool last_is_entered = settings.terms.size() > 1 && settings.terms.back().sigma_mm == 0;
  bindings.add("widest", resources.linear(in.lights[in.lights.size() - (last_is_entered ? 2 : 1)]))
      .add("stretch", resources.linear(in.stretch))
      .add("Terms", terms_)
      .add("sum_out", resources.storage(in.sum))
      .bind(cmd, pipeline());
  dispatch(cmd, io, square.side, square.side);
}

HandOver::Out HandOver::declare(frame::Declare& d) {
  d.kind(frame::PassKind::compute);
  d.sample(in.texture);
  return {};
}

}  // namespace dermis::passes
