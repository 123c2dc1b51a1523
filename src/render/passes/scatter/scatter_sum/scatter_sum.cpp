// SPDX-License-Identifier: MIT
#include "render/passes/scatter/scatter_sum/scatter_sum.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/scatter/scatter_sum/scatter_sum_io.h"

namespace dermis::passes {

ScatterSum::Out ScatterSum::declare(frame::Declare& d) {
  DERMIS_ASSERT_EQ(in.lights.size(), settings.weights.size());
  DERMIS_ASSERT_LE(in.lights.size(), std::size_t{MOST_TERMS});
  compute(d, "scatter_sum.comp", {{"term_count", static_cast<std::uint32_t>(in.lights.size())}});
  for (const frame::TextureId light : in.lights) d.sample(light);
  d.write(in.sum);
  return {in.sum};
}

void ScatterSum::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const Instance& instance = instance_of(frame, settings.square);
  if (!instance.visible) return;
  const UsedSquare square = used_square(frame, settings.square);
  const MapPlace& place = instance.map_places[mesh_in_asset(frame, settings.square)];

  io::ScatterSumIo io{.weights = {}, .origin = square.origin, .side = square.side, .layer = place.batch};
  for (std::size_t i = 0; i < settings.weights.size(); ++i) {
    const auto& [r, g, b] = settings.weights[i];
    io.weights[i] = {r, g, b};
  }

  static constexpr std::array names{"light_0", "light_1", "light_2", "light_3",
                                    "light_4", "light_5", "light_6", "light_7"};
  Bindings bindings;
  for (std::size_t i = 0; i < names.size(); ++i)
    bindings.add(names[i], resources.linear(in.lights[i < in.lights.size() ? i : 0]));
  bindings.add("sum_out", resources.storage(in.sum)).bind(cmd, pipeline());
  dispatch(cmd, io, square.side, square.side);
}

HandOver::Out HandOver::declare(frame::Declare& d) {
  d.kind(frame::PassKind::compute);
  d.sample(in.texture);
  return {};
}

}  // namespace dermis::passes
