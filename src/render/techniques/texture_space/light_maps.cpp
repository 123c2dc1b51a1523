// SPDX-License-Identifier: MIT
#include "render/techniques/texture_space/light_maps.h"

#include <algorithm>

#include "frame/together.h"
#include "render/passes/clear_buffers.h"
#include "render/passes/finish/count/count.h"
#include "render/passes/light_map/gutters/gutters.h"
#include "render/passes/light_map/host_irradiance/host_irradiance.h"
#include "render/passes/light_map/stretch/stretch.h"
#include "render/passes/light_map/texel_map/texel_map.h"
#include "render/passes/light_map/tiles/tiles.h"
#include "render/techniques/mapped_terms.h"
#include "render/techniques/texture_space/counters.h"

namespace dermis::techniques {

using frame::Together;
using passes::Gutters;
using passes::MapSquare;

LightMaps::LightMaps(passes::FramePlan& plan, const FrameSettings& settings, Screen& screen)
    : plan_(&plan), settings_(&settings), screen_(&screen), pool_(settings) {
  std::uint32_t materials = 1;
  for (const PlannedMesh& part : settings.skin) materials = std::max(materials, part.draws);
  tiles_ = passes::make_tile_lists(plan, pool_.squares(), settings.square_side, materials);
  texels_ = passes::make_texel_map(plan, pool_.texture());

  light_ = entered_ = make_map("irradiance");
  const bool reads_entered = std::ranges::any_of(settings.skin, &PlannedMesh::reads_entered);
  if (settings.translucency && reads_entered) entered_ = make_map("entered light");
  std::size_t terms = 0, groups = 1, scratch = 1;
  bool chains = false;  // blurs of some mesh begin after others have ended
  for (const PlannedMesh& part : settings.skin) {
    terms = std::max<std::size_t>(terms, part.mapped_count());
    groups = std::max(groups, part.through_groups().size());
    const std::size_t direct = direct_steps(settings, part);
    scratch = std::max(scratch, direct);
    chains = chains || direct < part.mapped_count();
  }
  for (std::size_t k = 0; k < scratch; ++k) scratch_.push_back(make_map(fmt::format("scratch {}", k)));
  // Nothing reads the light after the last blur then: that ends in its map.
  const bool light_ends = !chains && !settings.irradiance && (!reads_entered || settings.translucency);
  for (std::size_t k = 0; k < terms; ++k)
    blurred_.push_back(light_ends && k + 1 == terms ? light_ : make_map(fmt::format("light {}", k)));
  // The first group of transmitted light joins in the irradiance map itself.
  for (std::size_t g = 1; settings.translucency && g < groups; ++g)
    transmitted_.push_back(make_map(fmt::format("joining {}", g)));
  if (settings.host_lights()) host_irradiance_ = plan.texture("host irradiance", pool_.texture());
  make_stretch();
  screen.clear_with_ids({tiles_.marks, tiles_.counts, tiles_.arguments});
}

frame::TextureId LightMaps::make_map(std::string name) {
  light_maps_.push_back(plan_->texture(std::move(name), pool_.texture()));
  return light_maps_.back();
}

// A stretch map lasts from frame to frame, unless the skin meshes of a head take turns with it.
void LightMaps::make_stretch() {
  const std::uint32_t side = settings_->stretch_side;
  const gpu::TextureDesc map{.width = side, .height = side, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
  const auto lifetime = pool_.splits_heads() ? frame::Lifetime::transient : frame::Lifetime::persistent;
  std::uint32_t maps = pool_.splits_heads() ? pool_.meshes_per_batch() : 0;
  if (!pool_.splits_heads())
    for (const PlannedMesh& part : settings_->skin) maps = std::max(maps, part.unwrap + 1);
  for (std::uint32_t number = 0; number < maps; ++number)
    stretch_.push_back(plan_->texture(label_part("stretch", *settings_, number), map, lifetime));
}

frame::TextureId LightMaps::stretch(std::uint32_t mesh) const {
  const PlannedMesh& part = settings_->skin[mesh];
  return stretch_[pool_.splits_heads() ? part.in_model % pool_.meshes_per_batch() : part.unwrap];
}

std::vector<frame::TextureId> LightMaps::textures() const {
  std::vector<frame::TextureId> all = light_maps_;
  if (host_irradiance_.valid()) all.push_back(host_irradiance_);
  all.push_back(texels_);
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
  for (const StretchPass& pass : stretch_passes(squares)) {
    Together<passes::Stretch>::In maps;
    for (const MapSquare& square : pass.squares)
      maps.members.push_back({{stretch(square.mesh)},
                              {.square = square,
                               .runs = pass.runs,
                               .cut_out = settings_->skin[square.mesh].cut_out,
                               .when_moved = pass.when_moved}});
    plan_->add<Together<passes::Stretch>>(pass.name, maps);
  }
}

void LightMaps::add_stretch_gutters(const std::vector<MapSquare>& squares) {
  for (const StretchPass& pass : stretch_passes(squares)) {
    Together<Gutters>::In gutters;
    for (const MapSquare& square : pass.squares)
      gutters.members.push_back({{stretch(square.mesh)},
                                 {.squares = {square},
                                  .what = Gutters::What::stretch,
                                  .runs = pass.runs,
                                  .when_moved = pass.when_moved}});
    plan_->add<Together<Gutters>>(pass.name + " gutters", gutters);
  }
}

// Meshes that take turns with their maps need them anew in every frame, others once, or when they have moved.
std::vector<LightMaps::StretchPass> LightMaps::stretch_passes(const std::vector<MapSquare>& squares) const {
  StretchPass rigid{.name = "stretch", .runs = frame::Runs::once},
      posed{.name = "stretch of poses", .runs = frame::Runs::every_frame, .when_moved = true};
  if (pool_.splits_heads()) {
    rigid.name = name("stretch");
    rigid.runs = frame::Runs::every_frame;
  }
  for (const MapSquare& square : squares)
    (settings_->skin[square.mesh].posed && !pool_.splits_heads() ? posed : rigid).squares.push_back(square);
  std::vector<StretchPass> passes{std::move(rigid), std::move(posed)};
  std::erase_if(passes, [](const StretchPass& pass) { return pass.squares.empty(); });
  return passes;
}

void LightMaps::add_light(const std::vector<MapSquare>& all) {
  add_tiles(all);
  if (settings_->host_lights())
    plan_->add<passes::HostIrradiance>(name("host irradiance"), {host_irradiance_}, {.squares = all});

  // Light the texels of the tiles that are seen, and gather what comes through the body.
  const std::vector<PlannedMesh>& skin = settings_->skin;
  passes::Irradiance::Settings irradiance{
      .squares = all,
      .environment = settings_->environment,
      .soft_shadows = settings_->soft_shadows,
      .cut_out = std::any_of(skin.begin(), skin.end(), [](const PlannedMesh& part) { return part.cut_out; }),
      .from_host = settings_->host_lights(),
      .through = {}};
  if (settings_->translucency)
    for (const std::uint32_t mesh : meshes_of(all)) irradiance.through.push_back(skin[mesh].through(mesh));
  const passes::LitTexels::In texels{screen_->shadow(), screen_->entering(), texels_, tiles_};
  const bool apart = entered_.index != light_.index;
  plan_->add<passes::Irradiance>(
      name("irradiance"),
      {light_, apart ? entered_ : frame::TextureId{}, texels, transmitted_, host_irradiance_}, irradiance);
  if (settings_->translucency)
    plan_->add<passes::TransmissionMisses>(name("count transmission misses"), {texels, screen_->counters()},
                                           {irradiance, counter_transmission_misses});

  // Count for the statistics.
  Together<passes::Count>::In counts;
  for (const std::uint32_t mesh : meshes_of(all))
    counts.members.push_back({{light_, screen_->counters()},
                              {.slot = square_counter(*settings_, 0, skin[mesh].in_model, counter_lit_texels),
                               .slots_per_head = counter_head_stride(*settings_),
                               .squares = of_mesh(all, mesh)}});
  plan_->add<Together<passes::Count>>(name("count texels"), counts);

  Together<Gutters>::In gutters;
  gutters.members.push_back({{light_}, {.squares = all}});
  if (apart) gutters.members.push_back({{entered_}, {.squares = all}});
  plan_->add<Together<Gutters>>(name("irradiance gutters"), gutters);
}

// Finds the tiles that are lit and blurred, while the screen lists what it shows.
void LightMaps::add_tiles(const std::vector<MapSquare>& all) {
  if (turn_ > 0 || !settings_->draws_picture())
    plan_->add<passes::ClearBuffers>(name("clear tiles"), {{tiles_.marks, tiles_.counts, tiles_.arguments}});

  std::vector<float> exit_offsets;
  for (const PlannedMesh& part : settings_->skin) {
    const auto& shape = part.profile.shape;
    const double offset_mm = shape ? std::ranges::max(shape->exit_offset_mm) : 0;
    exit_offsets.push_back(static_cast<float>(offset_mm * part.max_uv_per_mm));
  }
  screen_->add_next_of_entries();
  plan_->add<passes::SeenTiles>(name("seen tiles"), {tiles_},
                                {.squares = all,
                                 .cull = settings_->optimise.cull,
                                 .clip = settings_->optimise.clip,
                                 .exit_offsets = exit_offsets});
  screen_->add_next_of_entries();
  plan_->add<passes::Tiles>(name("tiles"), {tiles_, screen_->counters(), light_maps_},
                            {.squares = all,
                             .first_slot = square_counter(*settings_, 0, 0, counter_tiles),
                             .slots_per_head = counter_head_stride(*settings_),
                             .slots_per_mesh = counter_mesh_stride});
}

// Finds which triangle each texel shows.
void LightMaps::add_texel_map(const std::vector<MapSquare>& all) {
  std::vector<std::uint32_t> unwraps;
  for (const PlannedMesh& part : settings_->skin) unwraps.push_back(part.unwrap);
  plan_->add<passes::TexelMap>(name("texel map"), {texels_}, {all, unwraps});
}

}  // namespace dermis::techniques
