// SPDX-License-Identifier: MIT
#include "techniques/texture_space/light_maps.h"

#include <algorithm>

#include "frame/together.h"
#include "passes/clear_buffers.h"
#include "passes/clear_texels/clear_texels.h"
#include "passes/count/count.h"
#include "passes/cull_triangles/cull_triangles.h"
#include "passes/dilate/dilate.h"
#include "passes/downsample/downsample.h"
#include "passes/gutters/gutters.h"
#include "passes/host_irradiance/host_irradiance.h"
#include "passes/stretch/stretch.h"
#include "passes/texel_list/texel_list.h"
#include "passes/texel_map/texel_map.h"
#include "passes/tiles/tiles.h"
#include "passes/transmission.h"
#include "techniques/texture_space/cascade.h"
#include "techniques/texture_space/counters.h"

namespace dermis::techniques {

using frame::Together;
using passes::Gutters;
using passes::MapSquare;

MapSquare on_level(MapSquare square, const Level& level) {
  square.halvings = level.halvings;
  return square;
}

std::vector<MapSquare> on_level(std::vector<MapSquare> squares, const Level& level) {
  for (MapSquare& square : squares) square = on_level(square, level);
  return squares;
}

std::string at(std::string_view what, const Level& level) {
  return level.halvings > 0 ? fmt::format("{} 1/{}", what, 1u << level.halvings) : std::string(what);
}

LightMaps::LightMaps(passes::FramePlan& plan, const FrameSettings& settings, Screen& screen)
    : plan_(&plan), settings_(&settings), screen_(&screen), pool_(settings) {
  std::uint32_t most_triangles = 0, most_materials = 1;
  for (const SkinPart& part : settings.skin) {
    most_triangles = std::max(most_triangles, part.triangles);
    most_materials = std::max(most_materials, part.draws);
  }
  if (settings.optimise.cull || (settings.texel_maps && settings.optimise.clip))
    kept_ = passes::make_kept_triangles(plan, pool_.squares(), most_triangles);
  if (settings.texel_maps)
    texels_ = {.map = passes::make_texel_map(plan, pool_.texture(0)),
               .lists = passes::make_texel_lists(plan, pool_.texture(0), pool_.squares(), most_materials)};
  if (settings.cascade)
    make_cascade();
  else
    make_chain();
  if (settings.host_lights()) host_irradiance_ = plan.texture("host irradiance", pool_.texture(0));
  make_stretch();
}

// A stretch map lasts from frame to frame, unless the skin meshes of a head take turns with it.
void LightMaps::make_stretch() {
  const gpu::TextureDesc map{
      .width = settings_->map_size, .height = settings_->map_size, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
  const auto lifetime = pool_.splits_heads() ? frame::Lifetime::transient : frame::Lifetime::persistent;
  std::uint32_t maps = pool_.splits_heads() ? pool_.meshes_per_batch() : 0;
  if (!pool_.splits_heads())
    for (const SkinPart& part : settings_->skin) maps = std::max(maps, part.unwrap + 1);
  for (std::uint32_t number = 0; number < maps; ++number)
    stretch_.push_back(plan_->texture(label_part("stretch", *settings_, number), map, lifetime));
}

// One level, with a map per term. The first group of transmitted light joins in the irradiance map itself;
// each further one has a map.
void LightMaps::make_chain() {
  std::size_t terms = 0;
  for (const SkinPart& part : settings_->skin) terms = std::max(terms, part.profile.terms.size());

  levels_.push_back(make_level(0));
  for (std::size_t k = 0; k < terms; ++k)
    blurred_.push_back(plan_->texture(fmt::format("light {}", k), pool_.texture(0)));
  levels_.front().blurred = blurred_;

  for (std::size_t g = 1; settings_->translucency && g < passes::transmission_groups(terms).size(); ++g)
    transmitted_.push_back(plan_->texture(fmt::format("joining {}", g), pool_.texture(0)));
}

// A level per size with one map for what has spread, one map for the sum, and a pyramid of light for each
// group of terms, down to its coarsest level.
void LightMaps::make_cascade() {
  std::vector<std::uint32_t> coarsest(TRANSMISSION_GROUPS, 0);
  std::uint32_t most = 0;
  std::size_t groups = 1;
  for (const SkinPart& part : settings_->skin) {
    const CascadePlan cascade = cascade_plan(*settings_, part);
    if (settings_->translucency) groups = std::max(groups, cascade.groups.size());
    for (const passes::CascadeStep& step : cascade.steps) {
      std::uint32_t& of_group = coarsest[cascade.group_of(step)];
      of_group = std::max(of_group, step.halvings);
      most = std::max(most, step.halvings);
    }
  }

  for (std::uint32_t halvings = 0; halvings <= most; ++halvings) {
    levels_.push_back(make_level(halvings));
    levels_.back().blurred.push_back(plan_->texture(at("spread", levels_.back()), pool_.texture(halvings)));
  }
  blurred_.push_back(plan_->texture("light", pool_.texture(0)));
  levels_.front().blurred.push_back(blurred_.front());

  for (std::size_t g = 1; g < groups; ++g) {
    transmitted_.push_back(plan_->texture(fmt::format("joining {}", g), pool_.texture(0)));
    for (std::uint32_t halvings = 1; halvings <= coarsest[g]; ++halvings)
      halved_transmitted_[{g, halvings}] =
          plan_->texture(at(fmt::format("joining {}", g), levels_[halvings]), pool_.texture(halvings));
  }
}

frame::TextureId LightMaps::unspread(std::size_t group, std::uint32_t halvings) const {
  if (group == 0 || transmitted_.empty()) return levels_[halvings].light;
  return halvings == 0 ? transmitted_[group - 1] : halved_transmitted_.at({group, halvings});
}

// Gutters of the larger map come down with the light. Made anew on the smaller one they would be worse: a
// source too near to a border moves by up to half a texel, and texels are larger there.
void LightMaps::add_level(std::uint32_t halvings, const std::vector<MapSquare>& squares) {
  const Level &larger = levels_[halvings - 1], &smaller = levels_[halvings];
  Together<passes::Downsample>::In in;
  for (const std::uint32_t mesh : meshes_of(squares)) {
    const std::vector<MapSquare> own = of_mesh(squares, mesh);
    in.members.push_back({{larger.light, stretch(mesh), smaller.light},
                          {.from = on_level(own, larger), .to = on_level(own, smaller)}});
  }
  plan_->add<Together<passes::Downsample>>(name(at("downsample", smaller)), in);
  add_masks(smaller, on_level(squares, smaller));
}

frame::TextureId LightMaps::stretch(std::uint32_t mesh) const {
  const SkinPart& part = settings_->skin[mesh];
  return stretch_[pool_.splits_heads() ? part.in_model % pool_.meshes_per_batch() : part.unwrap];
}

Level LightMaps::make_level(std::uint32_t halvings) {
  const std::uint32_t side = pool_.cell_side(halvings);
  Level level{.halvings = halvings};
  const auto name = [&](std::string_view what) { return at(what, level); };

  level.light = plan_->texture(name("irradiance"), pool_.texture(halvings));
  level.scratch = plan_->texture(name("scratch"), pool_.texture(halvings));
  if (is_sparse(*settings_)) {
    level.border = passes::make_tile_lists(*plan_, name("border"), pool_.squares(), side);
    level.lit = passes::make_tile_lists(*plan_, name("lit"), pool_.squares(), side);
  }
  return level;
}

std::vector<frame::TextureId> LightMaps::textures() const {
  std::vector<frame::TextureId> all = blurred_;
  all.insert(all.end(), transmitted_.begin(), transmitted_.end());
  for (const auto& [of, map] : halved_transmitted_) all.push_back(map);
  for (const frame::TextureId map : {texels_.map, texels_.lists.entries})
    if (map.valid()) all.push_back(map);
  if (host_irradiance_.valid()) all.push_back(host_irradiance_);
  for (const Level& level : levels_) {
    for (const frame::TextureId map : {level.light, level.scratch}) all.push_back(map);
    if (settings_->cascade) all.push_back(level.blurred.front());
  }
  return all;
}

std::string LightMaps::name(std::string_view what, std::uint32_t mesh) const {
  return name(label_part(what, *settings_, mesh));
}

std::string LightMaps::name(std::string_view what) const {
  const bool several = settings_->head_count() > settings_->heads_per_batch || pool_.splits_heads();
  return several ? fmt::format("{} batch {}", what, turn_) : std::string(what);
}

void LightMaps::add_stretch(const std::vector<MapSquare>& squares) {
  if (pool_.splits_heads()) {
    add_stretch("stretch", squares, frame::Runs::every_frame, false);
    return;
  }
  std::vector<MapSquare> rigid, posed;
  for (const MapSquare& square : squares)
    (settings_->skin[square.mesh].posed ? posed : rigid).push_back(square);
  add_stretch("stretch", rigid, frame::Runs::once, false);
  add_stretch("stretch of poses", posed, frame::Runs::every_frame, true);
}

void LightMaps::add_stretch(std::string_view what, const std::vector<MapSquare>& squares, frame::Runs runs,
                            bool when_moved) {
  Together<passes::Stretch>::In maps;
  Together<Gutters>::In gutters;
  for (const MapSquare& square : squares) {
    const frame::TextureId map = stretch(square.mesh);
    maps.members.push_back({{map},
                            {.square = square,
                             .runs = runs,
                             .cut_out = settings_->skin[square.mesh].cut_out,
                             .when_moved = when_moved}});
    gutters.members.push_back(
        {{map},
         {.squares = {square}, .what = Gutters::What::stretch, .runs = runs, .when_moved = when_moved}});
  }

  if (squares.empty()) return;
  const std::string of_gutters = fmt::format("{} gutters", what);
  const bool again = pool_.splits_heads();
  plan_->add<Together<passes::Stretch>>(again ? name(what) : std::string(what), maps);
  plan_->add<Together<Gutters>>(again ? name(of_gutters) : of_gutters, gutters);
}

void LightMaps::add_light(const std::vector<MapSquare>& all) {
  // Light every texel that is seen, and gather what comes through the body.
  const Level& level = levels_.front();
  const std::vector<SkinPart>& skin = settings_->skin;
  passes::Irradiance::Settings irradiance{
      .squares = all,
      .environment = settings_->environment,
      .soft_shadows = settings_->soft_shadows,
      .clip = settings_->optimise.clip,
      .cut_out = std::any_of(skin.begin(), skin.end(), [](const SkinPart& part) { return part.cut_out; }),
      .from_host = settings_->host_lights(),
      .through = {}};
  if (settings_->translucency)
    for (const std::uint32_t mesh : meshes_of(all))
      irradiance.through.push_back(
          {.mesh = mesh, .profile = skin[mesh].profile, .mm_per_unit = skin[mesh].mm_per_unit});

  if (kept_.valid())
    plan_->add<passes::CullTriangles>(name("cull triangles"), {kept_},
                                      {.squares = all,
                                       .cull = settings_->optimise.cull,
                                       .clip = texels_.valid() && settings_->optimise.clip});
  if (settings_->host_lights())
    plan_->add<passes::HostIrradiance>(name("host irradiance"), {host_irradiance_}, {.squares = all});
  add_irradiance(irradiance);

  // Count for the statistics.
  Together<passes::Count>::In counts;
  for (const std::uint32_t mesh : meshes_of(all))
    counts.members.push_back(
        {{level.light, screen_->counters()},
         {.slot = square_counter(*settings_, 0, skin[mesh].in_model, 0, counter_lit_texels),
          .slots_per_instance = counter_head_stride(*settings_),
          .squares = of_mesh(all, mesh)}});
  plan_->add<Together<passes::Count>>(name("count texels"), counts);

  add_masks(level, all);
}

// Lights the texels, and counts what their transmitted light did not find.
void LightMaps::add_irradiance(const passes::Irradiance::Settings& settings) {
  const passes::Irradiance::In in{levels_.front().light, screen_->shadow(), screen_->entering(),
                                  transmitted_,          host_irradiance_,  kept_};
  if (texels_.valid()) {
    add_texels(settings, in);
    return;
  }

  plan_->add<passes::Irradiance>(name("irradiance"), in, settings);
  if (settings_->translucency)
    plan_->add<passes::TransmissionMisses>(name("count transmission misses"),
                                           {in.shadow, in.entering, kept_, screen_->counters()},
                                           {.irradiance = settings, .slot = counter_transmission_misses});
}

// The same in compute: finds which triangle each texel shows, lists the texels that are lit, and lights
// those.
void LightMaps::add_texels(const passes::Irradiance::Settings& settings, const passes::Irradiance::In& in) {
  const std::vector<MapSquare>& squares = settings.squares;
  const passes::TexelLists& lists = texels_.lists;
  std::vector<std::uint32_t> unwraps;
  std::vector<bool> overlapping;
  for (const SkinPart& part : settings_->skin) {
    unwraps.push_back(part.unwrap);
    overlapping.push_back(kept_.valid() && part.overlaps);
  }
  const bool any = std::ranges::find(overlapping, true) != overlapping.end();
  plan_->add<passes::TexelMap>(name("texel map"), {texels_.map, any ? kept_ : passes::KeptTriangles{}},
                               {squares, unwraps, overlapping, settings.clip});

  plan_->add<passes::ClearBuffers>(name("clear texel lists"), {{lists.lists}});
  const auto list = [&](std::string_view what, bool counts_only) {
    plan_->add<passes::ListTexels>(name(what), {lists, texels_.map, kept_},
                                   {.squares = squares, .counts_only = counts_only});
  };
  const bool counts = lists.materials > 1;
  if (counts) list("texel counts", true);
  if (!counts) list("texel list", false);
  plan_->add<passes::TexelRanges>(name("texel ranges"), {lists}, {squares});
  if (counts) list("texel list", false);

  std::vector<frame::TextureId> maps{in.light};
  maps.insert(maps.end(), in.joining.begin(), in.joining.end());
  plan_->add<passes::ClearTexels>(name("clear irradiance"), {maps}, {squares});
  plan_->add<passes::IrradianceTexels>(name("irradiance"), {in, texels_}, {settings});
  if (settings_->translucency)
    plan_->add<passes::TransmissionMissesOfTexels>(name("count transmission misses"),
                                                   {in, texels_, screen_->counters()},
                                                   {settings, counter_transmission_misses});
}

// Prepares a level for blurring: seam gutters, dilation, tiles that hold light.
void LightMaps::add_masks(const Level& level, const std::vector<MapSquare>& all) {
  // Smaller levels have gutters by now, those of the larger map: see add_pyramid().
  if (level.halvings == 0)
    plan_->add<Gutters>(name(at("irradiance gutters", level)), {level.light}, {.squares = all});
  if (is_sparse(*settings_)) add_dilation(level, all);
  add_masked_counts(level, all);
  if (is_sparse(*settings_)) add_tiles(level, all);
}

// Extends the light to unlit texels beside lit ones, so that bilinear reads find light on all sides.
void LightMaps::add_dilation(const Level& level, const std::vector<MapSquare>& all) {
  plan_->add<passes::ClearBuffers>(name(at("clear border tiles", level)),
                                   {{level.border.counts, level.border.arguments}});
  plan_->add<passes::TileClasses>(name(at("border tile classes", level)), {level.light, level.border}, {all});
  plan_->add<passes::Tiles>(name(at("border tiles", level)), {level.border, screen_->counters()},
                            {.squares = all, .what = passes::Tiles::What::border});

  const auto dilate = [&](std::string_view what, frame::TextureId light) {
    Together<passes::Dilate>::In meshes;
    for (const std::uint32_t mesh : meshes_of(all))
      meshes.members.push_back({{light, stretch(mesh), level.border}, {of_mesh(all, mesh)}});
    plan_->add<Together<passes::Dilate>>(name(what), meshes);
  };
  dilate(at("dilate", level), level.light);
  for (std::size_t g = 0; level.halvings == 0 && g < transmitted_.size(); ++g)
    dilate(fmt::format("dilate joining {}", g + 1), transmitted_[g]);
}

// Counts the texels that convolutions do not skip.
void LightMaps::add_masked_counts(const Level& level, const std::vector<MapSquare>& all) {
  Together<passes::Count>::In counts;
  for (const std::uint32_t mesh : meshes_of(all))
    counts.members.push_back({{level.light, screen_->counters()},
                              {.slot = square_counter(*settings_, 0, settings_->skin[mesh].in_model,
                                                      level.halvings, counter_masked_texels),
                               .slots_per_instance = counter_head_stride(*settings_),
                               .threshold = 0.5f,
                               .absolute = true,
                               .squares = of_mesh(all, mesh)}});
  plan_->add<Together<passes::Count>>(name(at("count masked texels", level)), counts);
}

// Lists the tiles that hold light, and clears the others in every map that the blurs of this level write.
void LightMaps::add_tiles(const Level& level, const std::vector<MapSquare>& all) {
  std::vector<passes::IdleTiles::In::Map> maps{{.light = level.scratch}};
  for (std::uint32_t i = 0; i < level.blurred.size(); ++i)
    maps.push_back({.light = level.blurred[i], .term = settings_->cascade ? MOST_TERMS : i});
  plan_->add<passes::ClearBuffers>(name(at("clear tiles", level)), {{level.lit.counts, level.lit.arguments}});
  plan_->add<passes::TileClasses>(name(at("tile classes", level)), {level.light, level.lit}, {all});
  plan_->add<passes::Tiles>(name(at("tiles", level)), {level.lit, screen_->counters()},
                            {.squares = all,
                             .first_slot = square_counter(*settings_, 0, 0, level.halvings, counter_tiles),
                             .slots_per_instance = counter_head_stride(*settings_),
                             .slots_per_mesh = counter_mesh_stride});
  plan_->add<passes::IdleTiles>(name(at("idle tiles", level)), {level.lit, maps}, {.squares = all});
}

}  // namespace dermis::techniques
