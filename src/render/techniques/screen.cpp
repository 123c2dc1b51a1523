// SPDX-License-Identifier: MIT
#include "render/techniques/screen.h"

#include <algorithm>
#include <utility>

#include "frame/together.h"
#include "render/passes/clear_buffers.h"
#include "render/passes/finish/bloom/bloom.h"
#include "render/passes/finish/count/count.h"
#include "render/passes/finish/tone_map/tone_map.h"
#include "render/passes/light_map/light_floats/light_floats.h"
#include "render/passes/pixels/add_scattered/add_scattered.h"
#include "render/passes/pixels/background/background.h"
#include "render/passes/pixels/compose_entries/compose_entries.h"
#include "render/passes/pixels/ids/ids.h"
#include "render/passes/pixels/labels/front_layer.h"
#include "render/passes/pixels/labels/front_planes.h"
#include "render/passes/pixels/labels/label_planes.h"
#include "render/passes/pixels/labels/labels.h"
#include "render/passes/pixels/open_share/matte.h"
#include "render/passes/pixels/open_share/open_share.h"
#include "render/passes/pixels/resolve/resolve.h"
#include "render/passes/pixels/shade/shade.h"
#include "render/passes/pixels/shade/shade_pre_integrated.h"
#include "render/passes/pixels/shade/shade_split.h"
#include "render/passes/pixels/shade/unshaded_reads.h"
#include "render/passes/pixels/surface/surface.h"
#include "render/passes/pose/move_rig/move_rig.h"
#include "render/passes/pose/turn_sky/turn_sky.h"
#include "render/passes/shadow/shadow.h"

namespace dermis::techniques {

using frame::Together;

FrameReport screen_report(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                          std::span<const passes::Head>) {
  return {.skin_pixels = counters[counter_skin_pixels],
          .optimise = {},
          .mask = {},
          .translucency = settings.translucency};
}

FrameOutputs screen_maps(passes::FramePlan& plan, const FrameSettings& settings) {
  FrameOutputs out;
  out.shadow_maps = Screen(plan, settings).shadow_maps();
  return out;
}

std::vector<GutterSize> no_gutters(const FrameSettings&, std::span<const passes::Head>) { return {}; }

std::string label_part(std::string_view what, const FrameSettings& settings, std::uint32_t mesh) {
  return settings.skin.size() > 1 ? fmt::format("{} part {}", what, mesh) : std::string(what);
}

Screen::Screen(passes::FramePlan& plan, const FrameSettings& settings, std::size_t counters)
    : plan_(&plan), settings_(settings) {
  if (settings.host) colour();
  const auto lifetime = settings.host ? frame::Lifetime::of_host : frame::Lifetime::transient;
  if (settings.draws_picture())
    depth_ = plan.texture("depth", target(settings.picture_format().depth), lifetime);
  cleared_ = settings.host.has_value();
  if (settings.picture) make_shadow_maps();

  counters_ = plan.buffer("counters", {.bytes = counters * sizeof(std::uint32_t)});
  plan.add<passes::ClearBuffers>("clear counters", {{counters_}}, {frame::Runs::for_statistics});
  if (settings.poses) plan.add<passes::MoveRig>("pose", {}, {});
  if (settings.poses && settings.environment && settings.picture)
    plan.add<passes::TurnSky>("turn sky", {}, {});
}

void Screen::make_shadow_maps() {
  gpu::TextureDesc shadow{.width = settings_.shadow_size,
                          .height = settings_.shadow_size,
                          .layers = std::max(settings_.shadow_layers, 1u) * settings_.shadow_sets(),
                          .format = VK_FORMAT_D32_SFLOAT,
                          .array = true};
  const auto lasts = settings_.keep_shadows ? frame::Lifetime::persistent : frame::Lifetime::transient;
  shadow_ = plan_->texture("shadow maps", shadow, lasts);

  // A host's shadow map leaves no depth to draw against; where all light enters its depth alone has to say
  // whether a surface is the first one.
  const bool of_host = settings_.host && settings_.host->shadows;
  if (settings_.translucency && !(of_host && settings_.all_enters)) {
    gpu::TextureDesc entering = shadow;
    if (of_host) entering_depth_ = plan_->texture("entering depths", entering);
    entering.format = settings_.all_enters ? passes::facing_format : passes::entering_format;
    entering.grey_alpha = settings_.all_enters;
    entering_ = plan_->texture("entering maps", entering, lasts);
  }
}

gpu::TextureDesc Screen::target(VkFormat format) const {
  gpu::TextureDesc desc{.width = settings_.width, .height = settings_.height, .samples = settings_.samples};
  desc.format = format;
  return desc;
}

frame::TextureId Screen::colour() {
  const auto lifetime = settings_.host ? frame::Lifetime::of_host : frame::Lifetime::transient;
  if (!colour_.valid() && settings_.draws_picture())
    colour_ =
        plan_->texture(shaded() ? "layer" : "colour", target(settings_.picture_format().colour), lifetime);
  return colour_;
}

std::uint32_t Screen::first_part(const passes::MapSquare& square) const {
  std::uint32_t part = first_part_[square.head];
  for (std::uint32_t mesh = settings_.model_of(square.head).first_mesh; mesh < square.mesh; ++mesh)
    part += settings_.skin[mesh].parts;
  return part;
}

void Screen::add_ids() {
  if (!settings_.draws_picture() || !settings_.has_skin()) return;
  first_part_ = {0};
  for (std::uint32_t head = 0; head < settings_.head_count(); ++head)
    first_part_.push_back(first_part_.back() + settings_.parts_of(settings_.model_of(head)));

  passes::Ids::Settings ids{.samples = settings_.samples,
                            .reversed_depth = settings_.picture_format().reversed_depth,
                            .cut_out = false,
                            .meshes = {},
                            .whole = reads_open()};
  for (std::uint32_t head = 0; head < settings_.head_count(); ++head) {
    const Model& model = settings_.model_of(head);
    for (std::uint32_t mesh = model.first_mesh; mesh < model.first_mesh + model.meshes; ++mesh) {
      const passes::MapSquare square{.head = head, .mesh = mesh};
      ids.meshes.push_back({square, first_part(square)});
      ids.cut_out = ids.cut_out || settings_.skin[mesh].cut_out;
    }
  }

  entries_ = passes::make_entry_buffers(*plan_, first_part_.back(), target(passes::light_format));
  // A host's targets cannot be cleared, nor read.
  ids_depth_ = settings_.host ? plan_->texture("depth of ids", target(passes::depth_format)) : depth_;
  std::vector<frame::BufferId> cleared = cleared_with_ids_;
  cleared.push_back(entries_.parts);
  ids_ = plan_->add<passes::Ids>("ids", {ids_depth_, cleared}, ids).ids;
  entry_passes_left_ = 3;
}

void Screen::add_next_of_entries() {
  if (entry_passes_left_ == 3) plan_->add<passes::Entries>("entries", {ids_, ids_depth_, entries_});
  if (entry_passes_left_ == 2) plan_->add<passes::PartRanges>("part ranges", {entries_});
  if (entry_passes_left_ == 1) plan_->add<passes::EntryList>("entry list", {entries_});
  entry_passes_left_ = std::max(entry_passes_left_ - 1, 0);
}

passes::SkinLook Screen::look_of(passes::SkinLook look) const {
  const PlannedMesh& part = settings_.skin[look.square.mesh];
  look.environment = settings_.environment;
  look.soft_shadows = settings_.soft_shadows;
  look.samples = settings_.samples;
  look.light_samples = settings_.light_samples;
  look.off_map = part.off_map;
  look.kinds = part.kinds;
  return look;
}

passes::SkinLook Screen::whole_look_of(const passes::MapSquare& square) const {
  const PlannedMesh& part = settings_.skin[square.mesh];
  passes::SkinLook look = look_of({.square = square});
  if (settings_.translucency) look.through = part.through(square.mesh);
  return look;
}

void Screen::add_skin(const std::vector<SkinOnScreen>& skin, const std::string& name) {
  if (!settings_.draws_picture() || skin.empty()) return;
  add_entries();
  Together<passes::Shade>::In shade;
  for (const auto& [asked, maps] : skin)
    shade.members.push_back({{{maps, shadow_, entering_}, entries_},
                             {.look = look_of(asked), .first_part = first_part(asked.square)}});
  plan_->add<Together<passes::Shade>>(name, shade);
}

void Screen::add_unshaded_reads(const std::vector<SkinOnScreen>& skin, std::uint32_t slot,
                                const std::string& name) {
  if (!settings_.draws_picture() || settings_.host) return;
  add_entries();
  Together<passes::UnshadedReads>::In reads;
  for (const auto& [asked, maps] : skin)
    reads.members.push_back({{{maps, shadow_, entering_}, entries_, counters_},
                             {.look = look_of(asked), .first_part = first_part(asked.square), .slot = slot}});
  plan_->add<Together<passes::UnshadedReads>>(name, reads);
}

void Screen::add_split_skin(const std::vector<passes::MapSquare>& skin,
                            const std::vector<gaussians::Rgb>& blurred, const passes::ScreenSurface& surface,
                            const std::string& name) {
  DERMIS_ASSERT(shaded());
  if (skin.empty()) return;

  add_entries();
  Together<passes::ShadeSplit>::In split;
  for (const passes::MapSquare& square : skin) {
    const auto& [r, g, b] = blurred[square.mesh];
    const passes::SkinLights lights{{}, shadow_, entering_};
    split.members.push_back(
        {{lights, entries_, surface},
         {.look = whole_look_of(square),
          .blurred = {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)},
          .mm_per_unit = settings_.skin[square.mesh].mm_per_unit,
          .first_part = first_part(square),
          .first_part_of_head = first_part_[square.head],
          .end_part_of_head = first_part_[square.head + 1]}});
  }
  plan_->add<Together<passes::ShadeSplit>>(name, split);
}

void Screen::add_pre_integrated_skin(const std::vector<passes::MapSquare>& skin,
                                     const std::vector<frame::BufferId>& curvatures,
                                     std::uint32_t shadow_taps, const std::string& name) {
  DERMIS_ASSERT(shaded());
  add_entries();
  Together<passes::ShadePreIntegrated>::In shade;
  for (const passes::MapSquare& square : skin) {
    const PlannedMesh& part = settings_.skin[square.mesh];
    passes::ShadePreIntegrated::Settings settings{.look = whole_look_of(square),
                                                  .profile = part.profile,
                                                  .ring = settings_.kernel == ScreenKernel::published,
                                                  .shadow_taps = shadow_taps,
                                                  .mm_per_unit = part.mm_per_unit,
                                                  .first_part = first_part(square)};
    for (std::size_t c = 0; c < 3; ++c) settings.scattered[c] = static_cast<float>(1 - part.unscattered[c]);
    const passes::SkinLights lights{{}, shadow_, entering_};
    shade.members.push_back({{lights, entries_, curvatures[square.mesh]}, settings});
  }
  plan_->add<Together<passes::ShadePreIntegrated>>(name, shade);
}

void Screen::add_scattered(frame::TextureId blurred, const passes::ScreenSurface& surface) {
  plan_->add<passes::AddScattered>("add scattered", {blurred, surface.leaving, entries_});
}

bool Screen::take_clear() { return !std::exchange(cleared_, true); }

void Screen::add_shadows(const Batch& batch) {
  passes::Shadow::Settings shadow{.first_head = batch.first_head,
                                  .heads = batch.heads,
                                  .layers = std::max(settings_.shadow_layers, 1u),
                                  .host_maps = settings_.host && settings_.host->shadows};
  const bool apart = entering_depth_.valid();
  plan_->add<passes::Shadow>(label("shadow", settings_, batch),
                             {shadow_, apart ? frame::TextureId{} : entering_}, shadow);
  if (!apart) return;

  shadow.host_maps = false;
  shadow.grown = true;
  plan_->add<passes::Shadow>(label("entering", settings_, batch), {entering_depth_, entering_}, shadow);
}

void Screen::begin_batch(const Batch& batch) {
  add_shadows(batch);
  if (batch.number == 0) add_ids();
}

void Screen::end_batch(const Batch& batch) {
  add_surfaces(batch);
  add_blended(batch);
}

bool Screen::any_head(const Batch& batch, bool Model::*has) const {
  for (std::uint32_t i = 0; i < batch.heads; ++i)
    if (settings_.model_of(batch.first_head + i).*has) return true;
  return false;
}

bool Screen::has_other_parts(const Batch& batch) const {
  return any_head(batch, &Model::has_surfaces) || any_head(batch, &Model::has_blended);
}

void Screen::add_composed(const Batch& batch) {
  const std::uint32_t first = first_part_[batch.first_head],
                      end = first_part_[batch.first_head + batch.heads];
  plan_->add<passes::ComposeEntries>(label("compose", settings_, batch),
                                     {entries_, ids_, ids_depth_, colour_, depth_},
                                     {.samples = settings_.samples,
                                      .format = settings_.picture_format(),
                                      .first_part = first,
                                      .parts = end - first});
}

void Screen::add_surfaces(const Batch& batch) {
  if (!settings_.draws_picture()) return;
  if (shaded() && settings_.host) add_composed(batch);
  const bool clear = !cleared_ && !shaded();
  // A scene without any skin still needs its targets cleared.
  if (any_head(batch, &Model::has_surfaces) || clear)
    plan_->add<passes::Surface>(label("surfaces", settings_, batch), {shadow_, colour(), depth_},
                                {.first_head = batch.first_head,
                                 .heads = batch.heads,
                                 .samples = settings_.samples,
                                 .format = settings_.picture_format(),
                                 .clear = take_clear(),
                                 .layer = layered(),
                                 .environment = settings_.environment,
                                 .soft_shadows = settings_.soft_shadows});
}

void Screen::add_blended(const Batch& batch) {
  if (!any_head(batch, &Model::has_blended) || !settings_.draws_picture()) return;

  passes::Surface::Settings blended{.first_head = batch.first_head,
                                    .heads = batch.heads,
                                    .samples = settings_.samples,
                                    .format = settings_.picture_format(),
                                    .clear = layered() && take_clear(),
                                    .layer = layered(),
                                    .environment = settings_.environment,
                                    .soft_shadows = settings_.soft_shadows,
                                    .blended = true};
  plan_->add<passes::Surface>(label("blended surfaces", settings_, batch), {shadow_, colour(), depth_},
                              blended);
  const bool black = settings_.behind.kind == passes::Behind::Kind::black;
  if ((black && !settings_.matte) || shaded()) return;

  // Alpha of the picture marks skin: what is hidden needs a target of its own.
  blended.clear = !cover_.valid();
  blended.layer = true;
  if (!cover_.valid()) cover_ = plan_->texture("cover", target(passes::light_format));
  plan_->add<passes::Surface>(label("blended cover", settings_, batch), {shadow_, cover_, depth_}, blended);
}

std::vector<frame::TextureId> Screen::shadow_maps() const {
  std::vector<frame::TextureId> maps;
  for (const frame::TextureId map : {shadow_, entering_, entering_depth_})
    if (map.valid()) maps.push_back(map);
  return maps;
}

void Screen::add_labels(FrameOutputs& out) {
  const std::uint32_t width = settings_.width, height = settings_.height, wanted = settings_.labels;
  const bool has_front = (wanted & LABEL_FRONT_LAYER) != 0;
  // Where the layer alone is wanted, one label is drawn all the same, for its depth.
  const std::uint32_t behind = wanted & ~std::uint32_t{LABEL_FRONT_LAYER};
  const passes::Labels::Out labels =
      plan_->add<passes::Labels>("labels", {},
                                 {.width = width,
                                  .height = height,
                                  .labels = behind != 0 ? behind : LABEL_INSTANCE,
                                  .keeps_depth = has_front});
  out.labels = plan_
                   ->add<passes::LabelPlanes>("label planes", {labels.words},
                                              {.width = width, .height = height, .labels = wanted})
                   .planes;
  if (!has_front) return;

  using Shows = passes::FrontLayer::Shows;
  const auto layer = [&](const char* name, Shows shows) {
    return plan_
        ->add<passes::FrontLayer>(name, {labels.depth}, {.width = width, .height = height, .shows = shows})
        .layer;
  };
  const frame::TextureId coverage = layer("front coverage", Shows::coverage);
  const frame::TextureId parts = layer("front parts", Shows::part);
  out.labels = plan_
                   ->add<passes::FrontPlanes>("front planes", {coverage, parts, out.labels},
                                              {.width = width, .height = height, .labels = wanted})
                   .planes;
}

frame::TextureId Screen::add_picture() {
  if (shaded())
    return plan_->add<passes::ResolveEntries>("resolve", {entries_, colour_}, {settings_.samples}).picture;
  return settings_.samples > 1 ? plan_->add<passes::Resolve>("resolve", {colour()}).picture : colour();
}

frame::TextureId Screen::add_open_share() {
  return plan_
      ->add<passes::OpenShare>("open share", {depth_, shaded() ? colour_ : cover_}, {settings_.samples})
      .open;
}

bool Screen::reads_open() const {
  const passes::Behind& behind = settings_.behind;
  return !settings_.host &&
         (behind.is_light() || behind.kind == passes::Behind::Kind::colour || settings_.matte);
}

void Screen::add_display(FrameOutputs& out) {
  const passes::Behind& behind = settings_.behind;
  const bool is_colour = behind.kind == passes::Behind::Kind::colour;
  frame::TextureId open;
  if (reads_open()) open = add_open_share();
  if (settings_.matte)
    out.matte =
        plan_->add<passes::Matte>("matte", {open}, {.width = settings_.width, .height = settings_.height})
            .floats;
  if (!settings_.display && !settings_.linear) return;

  // Light shines into the lens; a colour of the display does not.
  if (behind.is_light())
    out.picture = plan_->add<passes::Background>("background", {out.picture, open}, {behind}).picture;
  passes::ToneMap::Settings tone_map{.tone_map = settings_.tone_map,
                                     .behind_srgb = behind.srgb,
                                     .bloom = settings_.bloom,
                                     .display = settings_.display};
  if (settings_.bloom > 0) tone_map.spread = passes::add_bloom(*plan_, out.picture);
  const passes::ToneMap::Out shown =
      plan_->add<passes::ToneMap>("tone map", {out.picture, is_colour ? open : frame::TextureId{}}, tone_map);
  out.picture = shown.light;
  out.display = shown.display;
}

FrameOutputs Screen::finish() {
  FrameOutputs out;
  out.counters = counters_;
  out.shadow_maps = shadow_maps();
  if (settings_.host) {
    out.host_colour = colour_;
    out.host_depth = depth_;
    return out;
  }
  if (settings_.picture) add_finished_picture(out);
  if (settings_.labels != 0) add_labels(out);
  return out;
}

void Screen::add_finished_picture(FrameOutputs& out) {
  out.picture = add_picture();
  plan_->add<passes::Count>("count skin pixels", {out.picture, counters_},
                            {.slot = counter_skin_pixels, .threshold = 0.5f});
  out.before_bloom = out.picture;
  add_display(out);
  if (settings_.linear)
    out.linear = plan_
                     ->add<passes::LightFloats>("linear picture", {out.picture},
                                                {.width = settings_.width, .height = settings_.height})
                     .floats;
  plan_->read_back(out.before_bloom);
  plan_->read_back(out.picture);
  if (out.display.valid()) plan_->read_back(out.display);
  plan_->read_back(shadow_);
  for (std::uint32_t layer = 0; layer < settings_.shadow_layers; ++layer)
    out.shows[fmt::format("shadow:{}", layer)] = {.map = shadow_, .as = Shown::As::depth, .layer = layer};
}

namespace {

FrameOutputs build_labels(passes::FramePlan& plan, const FrameSettings& settings) {
  return Screen(plan, settings).finish();
}

}  // namespace

constinit const Technique labels_alone{.name = "",
                                       .summary = "labels of each pixel, and no light",
                                       .uses_profile = false,
                                       .has_light_maps = false,
                                       .build = build_labels,
                                       .maps = screen_maps,
                                       .report = screen_report,
                                       .gutters = no_gutters};

}  // namespace dermis::techniques
