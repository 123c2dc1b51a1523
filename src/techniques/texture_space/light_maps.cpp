// SPDX-License-Identifier: MIT
#include "techniques/texture_space/light_maps.h"

#include <algorithm>

#include "frame/together.h"
#include "passes/clear_buffers.h"
#include "passes/clear_texels/clear_texels.h"
#include "passes/count/count.h"
#include "passes/cull_triangles/cull_triangles.h"
#include "passes/dilate/dilate.h"
#include "passes/gutters/gutters.h"
#include "passes/host_irradiance/host_irradiance.h"
#include "passes/stretch/stretch.h"
#include "passes/texel_list/texel_list.h"
#include "passes/texel_map/texel_map.h"
#include "passes/tiles/tiles.h"
#include "techniques/texture_space/counters.h"

namespace dermis::techniques {

using frame::Together;
using passes::Gutters;
using passes::MapSquare;

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
    texels_ = {.map = passes::make_texel_map(plan, pool_.texture()),
               .lists = passes::make_texel_lists(plan, pool_.texture(), pool_.squares(), most_materials)};

  light_ = plan.texture("irradiance", pool_.texture());
  scratch_ = plan.texture("scratch", pool_.texture());
  std::size_t terms = 0, groups = 1;
  for (const SkinPart& part : settings.skin) {
    terms = std::max<std::size_t>(terms, part.mapped_count());
    groups = std::max(groups, part.through_groups().size());
  }
  for (std::size_t k = 0; k < terms; ++k)
    blurred_.push_back(plan.texture(fmt::format("light {}", k), pool_.texture()));
  // The first group of transmitted light joins in the irradiance map itself.
  for (std::size_t g = 1; settings.translucency && g < groups; ++g)
    transmitted_.push_back(plan.texture(fmt::format("joining {}", g), pool_.texture()));
  if (is_sparse(settings)) {
    border_ = passes::make_tile_lists(plan, "border", pool_.squares(), pool_.cell_side());
    lit_ = passes::make_tile_lists(plan, "lit", pool_.squares(), pool_.cell_side());
  }
  if (settings.host_lights()) host_irradiance_ = plan.texture("host irradiance", pool_.texture());
  make_stretch();
}

// A stretch map lasts from frame to frame, unless the skin meshes of a head take turns with it.
void LightMaps::make_stretch() {
  const std::uint32_t side = stretch_side_of(*settings_);
  const gpu::TextureDesc map{.width = side, .height = side, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
  const auto lifetime = pool_.splits_heads() ? frame::Lifetime::transient : frame::Lifetime::persistent;
  std::uint32_t maps = pool_.splits_heads() ? pool_.meshes_per_batch() : 0;
  if (!pool_.splits_heads())
    for (const SkinPart& part : settings_->skin) maps = std::max(maps, part.unwrap + 1);
  for (std::uint32_t number = 0; number < maps; ++number)
    stretch_.push_back(plan_->texture(label_part("stretch", *settings_, number), map, lifetime));
}

frame::TextureId LightMaps::stretch(std::uint32_t mesh) const {
  const SkinPart& part = settings_->skin[mesh];
  return stretch_[pool_.splits_heads() ? part.in_model % pool_.meshes_per_batch() : part.unwrap];
}

std::vector<frame::TextureId> LightMaps::textures() const {
  std::vector<frame::TextureId> all = blurred_;
  all.insert(all.end(), transmitted_.begin(), transmitted_.end());
  for (const frame::TextureId map : {texels_.map, texels_.lists.entries})
    if (map.valid()) all.push_back(map);
  if (host_irradiance_.valid()) all.push_back(host_irradiance_);
  for (const frame::TextureId map : {light_, scratch_}) all.push_back(map);
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
    for (const std::uint32_t mesh : meshes_of(all)) irradiance.through.push_back(skin[mesh].through(mesh));

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
    counts.members.push_back({{light_, screen_->counters()},
                              {.slot = square_counter(*settings_, 0, skin[mesh].in_model, counter_lit_texels),
                               .slots_per_instance = counter_head_stride(*settings_),
                               .squares = of_mesh(all, mesh)}});
  plan_->add<Together<passes::Count>>(name("count texels"), counts);

  add_masks(all);
}

// Lights the texels, and counts what their transmitted light did not find.
void LightMaps::add_irradiance(const passes::Irradiance::Settings& settings) {
  const passes::Irradiance::In in{light_,       screen_->shadow(), screen_->entering(),
                                  transmitted_, host_irradiance_,  kept_};
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

// Prepares the light for blurring: seam gutters, dilation, tiles that hold light.
void LightMaps::add_masks(const std::vector<MapSquare>& all) {
  plan_->add<Gutters>(name("irradiance gutters"), {light_}, {.squares = all});
  if (is_sparse(*settings_)) add_dilation(all);
  add_masked_counts(all);
  if (is_sparse(*settings_)) add_tiles(all);
}

// Extends the light to unlit texels beside lit ones, so that bilinear reads find light on all sides.
void LightMaps::add_dilation(const std::vector<MapSquare>& all) {
  plan_->add<passes::ClearBuffers>(name("clear border tiles"), {{border_.counts, border_.arguments}});
  plan_->add<passes::TileClasses>(name("border tile classes"), {light_, border_}, {all});
  plan_->add<passes::Tiles>(name("border tiles"), {border_, screen_->counters()},
                            {.squares = all, .what = passes::Tiles::What::border});

  const auto dilate = [&](std::string_view what, frame::TextureId light) {
    Together<passes::Dilate>::In meshes;
    for (const std::uint32_t mesh : meshes_of(all))
      meshes.members.push_back({{light, stretch(mesh), border_}, {of_mesh(all, mesh)}});
    plan_->add<Together<passes::Dilate>>(name(what), meshes);
  };
  dilate("dilate", light_);
  for (std::size_t g = 0; g < transmitted_.size(); ++g)
    dilate(fmt::format("dilate joining {}", g + 1), transmitted_[g]);
}

// Counts the texels that convolutions do not skip.
void LightMaps::add_masked_counts(const std::vector<MapSquare>& all) {
  Together<passes::Count>::In counts;
  for (const std::uint32_t mesh : meshes_of(all))
    counts.members.push_back(
        {{light_, screen_->counters()},
         {.slot = square_counter(*settings_, 0, settings_->skin[mesh].in_model, counter_masked_texels),
          .slots_per_instance = counter_head_stride(*settings_),
          .threshold = 0.5f,
          .absolute = true,
          .squares = of_mesh(all, mesh)}});
  plan_->add<Together<passes::Count>>(name("count masked texels"), counts);
}

// Lists the tiles that hold light, and clears the others in every map that the blurs write.
void LightMaps::add_tiles(const std::vector<MapSquare>& all) {
  std::vector<passes::IdleTiles::In::Map> maps{{.light = scratch_}};
  for (std::uint32_t i = 0; i < blurred_.size(); ++i) maps.push_back({.light = blurred_[i], .term = i});
  plan_->add<passes::ClearBuffers>(name("clear tiles"), {{lit_.counts, lit_.arguments}});
  plan_->add<passes::TileClasses>(name("tile classes"), {light_, lit_}, {all});
  plan_->add<passes::Tiles>(name("tiles"), {lit_, screen_->counters()},
                            {.squares = all,
                             .first_slot = square_counter(*settings_, 0, 0, counter_tiles),
                             .slots_per_instance = counter_head_stride(*settings_),
                             .slots_per_mesh = counter_mesh_stride});
  plan_->add<passes::IdleTiles>(name("idle tiles"), {lit_, maps}, {.squares = all});
}

}  // namespace dermis::techniques
