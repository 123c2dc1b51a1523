// SPDX-License-Identifier: MIT
#include "render/setup/map_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "render/setup/frame_camera.h"
#include "render/techniques/mapped_terms.h"
#include "render/techniques/sides_by_need.h"

namespace dermis::setup {
namespace {

// The metric changes slowly over the skin: its maps are as large whatever light maps are, so that these
// change nothing for it.
constexpr std::uint32_t most_stretch_side = 1024;

// Returns pixels per mm at which no narrow term shows yet.
double before_close_ups(const techniques::FrameSettings& plan, const techniques::Model& model) {
  double most = std::numeric_limits<double>::infinity();
  for (std::uint32_t mesh = model.first_mesh; mesh < model.first_mesh + model.meshes; ++mesh)
    for (const Gaussian& term : plan.skin[mesh].profile.terms) {
      const double sigma_mm = std::sqrt(term.variance_mm2);
      if (sigma_mm < plan.skin[mesh].wide_mm)
        most = std::min(most, techniques::least_sigma_pixels(plan.skin[mesh], sigma_mm) / sigma_mm);
    }
  return most * (1 - 1e-6);
}

// Returns T_max of a model and its finest pixels: those of a near head, or of a close-up in this frame. So a
// plan changes where a head comes closer than that, and not before; other models change nothing for it.
passes::MapDetail finest_of(const FrameSetup& setup, std::uint32_t number, std::uint32_t limit) {
  const techniques::Model& model = setup.plan.models[number];
  passes::MapDetail finest{0, 0};
  for (std::uint32_t mesh = model.first_mesh; mesh < model.first_mesh + model.meshes; ++mesh)
    finest.side = std::max(finest.side, techniques::near_side(setup.plan.skin[mesh], limit));
  for (const passes::Head& head : setup.heads) {
    if (head.model != number || !head.visible) continue;
    finest.side = std::max(finest.side, head.detail.side);
    finest.pixels_per_mm = std::max(finest.pixels_per_mm, head.detail.pixels_per_mm);
  }
  return finest;
}

// Has maps hold what shows, and no more.
void hold_what_shows(FrameSetup& setup, std::uint32_t limit, bool every_view) {
  techniques::FrameSettings& plan = setup.plan;
  plan.most_side = 0;

  for (std::uint32_t number = 0; number < plan.models.size(); ++number) {
    const techniques::Model& model = plan.models[number];
    const passes::MapDetail finest = finest_of(setup, number, limit);
    for (passes::Head& head : setup.heads)
      if (head.model == number) head.detail.side = std::min(head.detail.side, finest.side);
    if (model.meshes > 0) plan.most_side = std::max(plan.most_side, finest.side);

    for (techniques::PlannedMesh& part : std::span(plan.skin).subspan(model.first_mesh, model.meshes)) {
      part.most_side = finest.side;
      part.first_mapped = techniques::first_mapped(part, finest);
      const auto is_coarse = [&](const passes::Head& head) {
        return head.model == number && head.visible && techniques::entered_share(part, head.detail) > 0;
      };
      part.reads_entered = part.first_mapped > 0 && part.mapped_count() < MOST_TERMS &&
                           (every_view || std::ranges::any_of(setup.heads, is_coarse));
    }
  }
}

}  // namespace

std::vector<std::uint32_t> map_sides(const techniques::FrameSettings& plan, const RenderSettings& s) {
  if (!plan.optimise.depth) return {plan.most_side};
  if (plan.mixes()) return techniques::sides_by_need(plan.most_side);
  const std::vector<int> sides = paper_sides(s);
  return {sides.begin(), sides.end()};
}

void set_head_sides(FrameSetup& setup, const PlacedScene& scene, const RenderSettings& s) {
  const techniques::FrameSettings& plan = setup.plan;
  if (plan.skin.empty() || !setup.technique->has_light_maps) return;

  for (passes::Head& head : setup.heads) {
    passes::MapDetail& detail = head.detail;
    const techniques::Model& model = plan.models[head.model];
    // The plan of a host must serve every view: it has no close-ups.
    if (plan.host && plan.mixes())
      detail.pixels_per_mm = std::min(detail.pixels_per_mm, before_close_ups(plan, model));
    detail.side = model.meshes > 0 ? plan.skin[model.first_mesh].most_side : plan.most_side;
    if (plan.mixes())
      detail.side = techniques::side_by_need(plan, model, detail.pixels_per_mm, detail.side);
    else if (const scene::AssetData& asset = *scene.instances[head.instance].asset;
             plan.optimise.depth && !asset.skin.empty())
      detail.side = static_cast<std::uint32_t>(paper_side(asset, s, detail.pixels_per_mm));
  }
}

void set_up_map_sides(FrameSetup& setup, const PlacedScene& scene, const RenderSettings& s, bool every_view) {
  techniques::FrameSettings& plan = setup.plan;
  const auto limit = static_cast<std::uint32_t>(s.quality.map_size);
  plan.set_most_side(limit);
  if (plan.mixes()) plan.stretch_side = std::min(limit, most_stretch_side);

  set_head_sides(setup, scene, s);
  if (!plan.skin.empty() && plan.mixes()) hold_what_shows(setup, limit, every_view);
}

}  // namespace dermis::setup
