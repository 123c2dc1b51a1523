// SPDX-License-Identifier: MIT
#include "render/techniques/texture_space/texture_space.h"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "render/passes/light_map/show_visibility/show_visibility.h"
#include "render/passes/scatter/scatter_sum/scatter_sum.h"
#include "render/techniques/screen.h"
#include "render/techniques/texture_space/convolution.h"
#include "render/techniques/texture_space/counters.h"
#include "render/techniques/texture_space/final.h"
#include "render/techniques/texture_space/light_maps.h"
#include "render/techniques/texture_space/report.h"

namespace dermis::techniques {
namespace {

using passes::MapSquare;

// The square that `show` names: the first skin mesh of the last head that has skin. Heads are drawn far to
// near then.
MapSquare shown_square(const FrameSettings& s) {
  std::uint32_t head = s.head_count() - 1;
  while (head > 0 && s.model_of(head).meshes == 0) --head;
  return {.head = head, .mesh = s.model_of(head).first_mesh};
}

// Makes the map that shows which of its texels are lit.
frame::TextureId add_visibility(passes::FramePlan& plan, const FrameSettings& s) {
  const gpu::TextureDesc map{
      .width = s.most_side, .height = s.most_side, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
  const frame::TextureId visibility = plan.texture("visibility", map, frame::Lifetime::persistent);
  plan.add<passes::ShowVisibility>("visibility", {visibility},
                                   {.square = shown_square(s),
                                    .cull = s.optimise.cull,
                                    .clip = s.optimise.clip,
                                    .cut_out = s.skin[shown_square(s).mesh].cut_out});
  return visibility;
}

// Names what `show` can name: maps of the shown square, and the metric of its unwrap.
void add_shows(FrameOutputs& out, passes::FramePlan& plan, const FrameSettings& s, const LightMaps& maps) {
  const MapSquare square = shown_square(s);
  const auto light = [&](frame::TextureId map, Shown::Needs needs, std::uint32_t term) {
    return Shown{.map = map,
                 .as = Shown::As::light,
                 .origin = maps.pool().place(square.head, 0).origin,
                 .used_square = true,
                 .needs = needs,
                 .term = term};
  };
  out.shows["irradiance"] = light(maps.light(), Shown::Needs::irradiance, 0);
  for (std::uint32_t k = 0; k < s.skin[square.mesh].mapped_count(); ++k)
    out.shows[fmt::format("blur:{}", s.skin[square.mesh].first_mapped + k)] =
        light(maps.blurred()[k], Shown::Needs::term, k);

  out.shows["stretch"] = {.map = maps.stretch(square.mesh)};
  out.shows["texel-density"] = {.map = maps.stretch(square.mesh), .as = Shown::As::texel_density};
  if (s.visibility) out.shows["visibility"] = {.map = add_visibility(plan, s), .used_square = true};
  for (const auto& [name, shown] : out.shows) plan.read_back(shown.map);
}

// Makes the map of a host that reads the blurred light; not valid if there is none.
frame::TextureId make_scattered(passes::FramePlan& plan, const FrameSettings& s, const MapPool& pool) {
  if (!s.host || !s.host->scattered) return {};
  gpu::TextureDesc desc = pool.texture();
  desc.layers = passes::ScatterSum::layer_of(pool.batches());
  desc.array = true;
  return plan.texture("scattered light", desc, frame::Lifetime::persistent);
}

// Squares of the first head that has each unwrap.
std::vector<MapSquare> one_of_each_unwrap(const FrameSettings& s) {
  std::map<std::uint32_t, MapSquare> found;
  for (std::uint32_t head = 0; head < s.head_count(); ++head)
    for (std::uint32_t i = 0; i < s.model_of(head).meshes; ++i) {
      const std::uint32_t mesh = s.model_of(head).first_mesh + i;
      found.try_emplace(s.skin[mesh].unwrap, MapSquare{.head = head, .mesh = mesh});
    }

  std::vector<MapSquare> squares;
  for (const auto& [unwrap, square] : found) squares.push_back(square);
  return squares;
}

// The steps of the table in docs/techniques.md, in its order.
FrameOutputs build_texture_space(passes::FramePlan& plan, const FrameSettings& s) {
  Screen screen(plan, s, counter_count(s));
  std::optional<LightMaps> maps;
  if (!s.skin.empty()) maps.emplace(plan, s, screen);
  const MapPool pool(s);
  const frame::TextureId scattered = maps ? make_scattered(plan, s, pool) : frame::TextureId{};

  // Stretch, once: a rigid mesh keeps its metric, unless another mesh takes its map.
  if (!pool.splits_heads() && maps) maps->add_stretch(one_of_each_unwrap(s));

  for (const Batch& batch : batches_of(s)) {
    screen.begin_batch(batch);

    // The first meshes come last, so that what `show` reads is of the first one.
    const std::uint32_t turns = pool.mesh_batches();
    for (std::uint32_t turn = 0; turn < turns; ++turn) {
      const std::vector<MapSquare> squares = pool.squares(batch, turns - 1 - turn);
      if (squares.empty()) continue;

      maps->begin_turn(batch.number * turns + turn);
      if (pool.splits_heads()) maps->add_stretch(squares);
      maps->add_texel_map(squares);
      if (pool.splits_heads())
        maps->add_stretch_gutters(squares);
      else if (turn == 0 && batch.number == 0)
        maps->add_stretch_gutters(one_of_each_unwrap(s));
      maps->add_light(squares);
      add_convolution(plan, s, *maps, squares);
      if (scattered.valid()) add_scatter_sum(plan, s, *maps, scattered, squares);
      add_final(s, screen, *maps, squares);
    }

    screen.end_batch(batch);
  }

  FrameOutputs out = screen.finish();
  if (!maps) return out;
  out.light_maps = maps->textures();
  out.map_places = pool.places();
  if (scattered.valid()) plan.add<passes::HandOver>("hand over scattered light", {scattered});
  out.scattered = scattered;
  if (!s.host) add_shows(out, plan, s, *maps);
  return out;
}

FrameOutputs maps(passes::FramePlan& plan, const FrameSettings& s) {
  Screen screen(plan, s, counter_count(s));
  FrameOutputs out;
  out.shadow_maps = screen.shadow_maps();
  if (!s.skin.empty()) out.light_maps = LightMaps(plan, s, screen).textures();
  return out;
}

}  // namespace

constinit const Technique texture_space{
    .name = "texture-space",
    .summary = "light blurred in the head's texture by a sum of Gaussians (d'Eon et al. 2007)",
    .uses_profile = true,
    .has_light_maps = true,
    .build = build_texture_space,
    .maps = maps,
    .report = texture_space_report,
    .gutters = texture_space_gutters};

}  // namespace dermis::techniques
