// SPDX-License-Identifier: MIT
#include "techniques/texture_space/texture_space.h"

#include <algorithm>
#include <optional>

#include "passes/show_visibility/show_visibility.h"
#include "techniques/screen.h"
#include "techniques/texture_space/convolution.h"
#include "techniques/texture_space/counters.h"
#include "techniques/texture_space/final.h"
#include "techniques/texture_space/light_maps.h"
#include "techniques/texture_space/report.h"

namespace dermis::techniques {
namespace {

using passes::MapSquare;

// Makes the map that shows which texels of the nearest head's first skin mesh are lit.
frame::TextureId add_visibility(passes::FramePlan& plan, const FrameSettings& s) {
  const gpu::TextureDesc map{
      .width = s.map_size, .height = s.map_size, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
  const frame::TextureId visibility = plan.texture("visibility", map, frame::Lifetime::persistent);
  plan.add<passes::ShowVisibility>("visibility", {visibility},
                                   {.square = {.instance = s.heads - 1, .mesh = 0},
                                    .cull = s.optimise.cull,
                                    .clip = s.optimise.clip,
                                    .cut_out = s.skin.front().cut_out});
  return visibility;
}

// Names what `show` can name: squares of the nearest head's first skin mesh (heads are drawn far to near),
// and the metric of its unwrap.
void add_shows(FrameOutputs& out, passes::FramePlan& plan, const FrameSettings& s, const LightMaps& maps) {
  const auto light = [&](frame::TextureId map) {
    const glm::uvec2 origin = maps.pool().place(s.heads - 1, 0).origin;
    return Shown{.map = map, .as = Shown::As::light, .origin = origin, .used_square = true};
  };
  out.shows["irradiance"] = light(maps.levels().front().light);
  for (std::size_t k = 0; k < maps.blurred().size(); ++k)
    out.shows[fmt::format("blur:{}", k)] = light(maps.blurred()[k]);

  out.shows["stretch"] = {.map = maps.stretch(0)};
  out.shows["texel-density"] = {.map = maps.stretch(0), .as = Shown::As::texel_density};
  if (s.visibility) out.shows["visibility"] = {.map = add_visibility(plan, s), .used_square = true};
  for (const auto& [name, shown] : out.shows) plan.read_back(shown.map);
}

// The steps of the table in docs/techniques.md, in its order.
FrameOutputs build(passes::FramePlan& plan, const FrameSettings& s) {
  const auto meshes = static_cast<std::uint32_t>(s.skin.size());
  Screen screen(plan, s, counter_count(meshes));
  std::optional<LightMaps> maps;
  if (meshes > 0) maps.emplace(plan, s, screen);
  const MapPool pool(s);

  // Stretch, once: a rigid mesh keeps its metric, unless another mesh takes its map.
  for (std::uint32_t mesh = 0; mesh < meshes && !pool.splits_heads(); ++mesh) maps->add_stretch(mesh);

  for (std::uint32_t first_head = 0; first_head < s.heads; first_head += s.heads_per_batch) {
    const std::uint32_t heads = std::min(s.heads_per_batch, s.heads - first_head);
    for (std::uint32_t i = 0; i < heads; ++i) screen.add_shadow(first_head + i);

    // Light and blur. The first meshes come last, so that what `show` reads is of the first one.
    for (std::uint32_t batch = pool.mesh_batches(); batch-- > 0; maps->begin_batch()) {
      const std::uint32_t first = batch * pool.meshes_per_batch();
      const std::uint32_t end = std::min(first + pool.meshes_per_batch(), meshes);
      const std::vector<MapSquare> squares = pool.squares(first_head, heads, first, end);

      for (std::uint32_t mesh = first; mesh < end && pool.splits_heads(); ++mesh) maps->add_stretch(mesh);
      maps->add_light(squares);
      for (std::uint32_t mesh = first; mesh < end; ++mesh)
        add_convolution(plan, s, *maps, mesh, of_mesh(squares, mesh));

      // Others take these squares afterwards: draw what they hold now.
      for (const MapSquare& square : squares)
        if (pool.splits_heads()) add_final(plan, s, screen, *maps, square);
    }

    // Draw the heads, skin first.
    for (std::uint32_t head = first_head; head < first_head + heads; ++head) {
      for (std::uint32_t mesh = 0; mesh < meshes && !pool.splits_heads(); ++mesh)
        add_final(plan, s, screen, *maps, {.instance = head, .mesh = mesh});
      screen.add_surfaces(head);
    }
  }

  FrameOutputs out = screen.finish();
  if (!maps) return out;
  out.light_maps = maps->textures();
  out.map_places = pool.places();
  add_shows(out, plan, s, *maps);
  return out;
}

FrameOutputs maps(passes::FramePlan& plan, const FrameSettings& s) {
  Screen screen(plan, s, counter_count(s.skin.size()));
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
    .build = build,
    .maps = maps,
    .report = texture_space_report,
    .gutters = texture_space_gutters};

}  // namespace dermis::techniques
