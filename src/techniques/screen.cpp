// SPDX-License-Identifier: MIT
#include "techniques/screen.h"

#include <algorithm>

#include "passes/bloom/bloom.h"
#include "passes/count/count.h"
#include "passes/labels/labels.h"
#include "passes/move_rig/move_rig.h"
#include "passes/resolve/resolve.h"
#include "passes/shadow/shadow.h"
#include "passes/surface/surface.h"
#include "passes/tone_map/tone_map.h"

namespace dermis::techniques {
namespace {

// Side of the maps of what enters the skin (passes::Shadow), texels. Their light goes to light maps, so they
// need not be finer than those. Within a factor of 1.5 a pass of their own would save neither time nor
// memory: they are drawn with the shadow maps then, and as large.
std::uint32_t entering_size(const FrameSettings& s) {
  return 3 * std::uint64_t{s.map_size} <= 2 * std::uint64_t{s.shadow_size} ? s.map_size : s.shadow_size;
}

}  // namespace

FrameReport screen_report(const FrameSettings&, std::span<const std::uint32_t> counters,
                          std::span<const DrawnHead>) {
  return {.skin_pixels = counters[counter_skin_pixels], .optimise = {}, .mask = {}, .maps = {}};
}

FrameOutputs screen_maps(passes::FramePlan& plan, const FrameSettings& settings) {
  FrameOutputs out;
  out.shadow_maps = Screen(plan, settings).shadow_maps();
  return out;
}

std::vector<GutterSize> no_gutters(const FrameSettings&, std::span<const DrawnHead>) { return {}; }

std::string label(std::string_view what, const FrameSettings& settings, std::uint32_t head,
                  std::uint32_t mesh) {
  const std::string name = label(what, settings, head);
  if (settings.model_of(head).meshes < 2) return name;
  return fmt::format("{} part {}", name, settings.skin[mesh].in_model);
}

std::string label_part(std::string_view what, const FrameSettings& settings, std::uint32_t mesh) {
  return settings.skin.size() > 1 ? fmt::format("{} part {}", what, mesh) : std::string(what);
}

std::string label(std::string_view what, const FrameSettings& settings, std::uint32_t head) {
  return settings.heads.size() > 1 ? fmt::format("{} head {}", what, head) : std::string(what);
}

Screen::Screen(passes::FramePlan& plan, const FrameSettings& settings, std::size_t counters)
    : plan_(&plan), settings_(settings) {
  const gpu::TextureDesc screen{
      .width = settings.width, .height = settings.height, .samples = settings.samples};
  gpu::TextureDesc colour = screen, depth = screen;
  colour.format = settings.picture_format().colour;
  depth.format = settings.picture_format().depth;
  const auto lifetime = settings.host ? frame::Lifetime::of_host : frame::Lifetime::transient;
  if (settings.draws_picture()) {
    colour_ = plan.texture("colour", colour, lifetime);
    depth_ = plan.texture("depth", depth, lifetime);
  }
  cleared_ = settings.host.has_value();

  gpu::TextureDesc shadow{.width = settings.shadow_size,
                          .height = settings.shadow_size,
                          .layers = std::max(settings.shadow_layers, 1u) * settings.heads_per_batch,
                          .format = VK_FORMAT_D32_SFLOAT,
                          .array = true};
  shadow_ = plan.texture("shadow maps", shadow);

  if (settings.translucency && !settings.all_enters) {
    gpu::TextureDesc entering = shadow;
    entering.width = entering.height = entering_size(settings);
    // A host's shadow map leaves no depth to draw against.
    const bool of_host = settings.host && settings.host->shadows;
    if (of_host || entering.width < shadow.width) entering_depth_ = plan.texture("entering depths", entering);
    entering.format = VK_FORMAT_R8G8B8A8_UNORM;
    entering_ = plan.texture("entering maps", entering);
  }

  counters_ = plan.buffer("counters", {.bytes = counters * sizeof(std::uint32_t)});
  plan.add<passes::ClearCounters>("clear counters", {counters_});
  if (settings.poses) plan.add<passes::MoveRig>("pose", {}, {});
}

bool Screen::take_clear() { return !std::exchange(cleared_, true); }

void Screen::add_shadow(std::uint32_t head) {
  const std::uint32_t layers = std::max(settings_.shadow_layers, 1u);
  const bool apart = entering_depth_.valid();
  plan_->add<passes::Shadow>(
      label("shadow", settings_, head), {shadow_, apart ? frame::TextureId{} : entering_},
      {.instance = head, .layers = layers, .host_maps = settings_.host && settings_.host->shadows});
  if (apart)
    plan_->add<passes::Shadow>(label("entering", settings_, head), {entering_depth_, entering_},
                               {.instance = head, .layers = layers, .grown = true});
}

void Screen::add_surfaces(std::uint32_t head) {
  if (!settings_.draws_picture()) return;
  const passes::Surface::In in{shadow_, colour_, depth_};
  const bool clear = !cleared_;
  // A scene without any skin still needs its targets cleared.
  if (settings_.model_of(head).has_surfaces || clear)
    plan_->add<passes::Surface>(label("surfaces", settings_, head), in,
                                {.instance = head,
                                 .samples = settings_.samples,
                                 .format = settings_.picture_format(),
                                 .clear = take_clear(),
                                 .environment = settings_.environment,
                                 .soft_shadows = settings_.soft_shadows});
}

void Screen::add_blended(std::uint32_t first_head, std::uint32_t heads) {
  bool any = false;
  for (std::uint32_t i = 0; i < heads; ++i) any = any || settings_.model_of(first_head + i).has_blended;
  if (!any || !settings_.draws_picture()) return;

  plan_->add<passes::Surface>(label("blended surfaces", settings_, first_head), {shadow_, colour_, depth_},
                              {.instance = first_head,
                               .instances = heads,
                               .samples = settings_.samples,
                               .format = settings_.picture_format(),
                               .environment = settings_.environment,
                               .soft_shadows = settings_.soft_shadows,
                               .blended = true});
}

std::vector<frame::TextureId> Screen::shadow_maps() const {
  std::vector<frame::TextureId> maps;
  for (const frame::TextureId map : {shadow_, entering_, entering_depth_})
    if (map.valid()) maps.push_back(map);
  return maps;
}

void Screen::add_labels(FrameOutputs& out) {
  const passes::Labels::Out labels =
      plan_->add<passes::Labels>("labels", {}, {.width = settings_.width, .height = settings_.height});
  out.label_surface = labels.surface;
  out.label_names = labels.names;
  plan_->read_back(out.label_surface);
  plan_->read_back(out.label_names);
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

  out.picture = settings_.samples > 1 ? plan_->add<passes::Resolve>("resolve", {colour_}).picture : colour_;
  plan_->add<passes::Count>("count skin pixels", {out.picture, counters_},
                            {.slot = counter_skin_pixels, .threshold = 0.5f});
  out.before_bloom = out.picture;
  if (settings_.bloom > 0) out.picture = passes::add_bloom(*plan_, out.picture, settings_.bloom);
  out.display = plan_->add<passes::ToneMap>("tone map", {out.picture}, {settings_.tone_map}).display;
  if (settings_.labels) add_labels(out);
  plan_->read_back(out.before_bloom);
  if (settings_.bloom > 0) plan_->read_back(out.picture);
  plan_->read_back(out.display);
  plan_->read_back(shadow_);
  for (std::uint32_t layer = 0; layer < settings_.shadow_layers; ++layer)
    out.shows[fmt::format("shadow:{}", layer)] = {.map = shadow_, .as = Shown::As::depth, .layer = layer};
  return out;
}

}  // namespace dermis::techniques
