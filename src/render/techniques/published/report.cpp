// SPDX-License-Identifier: MIT
#include "render/techniques/published/report.h"

#include <algorithm>

#include "render/techniques/published/blur_io.h"
#include "render/techniques/published/kernels.h"

namespace dermis::techniques::papers {

Mask mask_of(const FrameSettings& settings) {
  if (!settings.optimise.cull && !settings.optimise.clip) return Mask::none;
  return settings.mask == BlurMask::alpha ? Mask::alpha : Mask::depth;
}

namespace {

// Adds what a skin mesh of head `number` has taken.
void add_object(FrameReport& report, const FrameSettings& settings, std::span<const std::uint32_t> counters,
                const passes::Head& head, std::uint32_t number, std::uint32_t mesh_in_model) {
  const std::uint32_t mesh = settings.models[head.model].first_mesh + mesh_in_model;
  const PlannedMesh& part = settings.skin[mesh];
  const auto counted = [&](ObjectCounter which) -> std::uint64_t {
    return counters[object_counter(settings, number, mesh_in_model, which)];
  };

  const std::uint64_t terms = part.profile.terms.size(),
                      convolutions = 2 * steps_of(part.profile, settings.chain_texels_per_mm(part)).size();
  // With the alpha test fragments without light end early, but they start.
  const std::uint64_t at_once = mask_of(settings) == Mask::depth
                                    ? counted(counter_masked_texels)
                                    : std::uint64_t{head.detail.side} * head.detail.side;
  report.irradiance_texels += counted(counter_lit_texels);
  report.convolved_texels += counted(counter_lit_texels) * terms;
  report.launched += counted(counter_lit_texels) + at_once * convolutions;
  report.light_reads += at_once * convolutions * (2 * PAPER_TAPS + 1);
}

}  // namespace

FrameReport report(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                   std::span<const passes::Head> heads) {
  DERMIS_ASSERT_EQ(counters.size(), counter_count(settings));
  FrameReport report = screen_report(settings, counters, heads);
  if (settings.optimise.cull) report.optimise.emplace_back("cull");
  if (settings.optimise.depth) report.optimise.emplace_back("depth");
  if (settings.optimise.clip) report.optimise.emplace_back("clip");
  if (mask_of(settings) != Mask::none) report.mask = mask_of(settings) == Mask::alpha ? "alpha" : "depth";
  report.unshaded_reads = counters[counter_unshaded_reads];
  report.transmission_misses = counters[counter_missed_light];

  for (std::uint32_t number = 0; number < heads.size(); ++number) {
    if (!heads[number].visible) continue;
    for (std::uint32_t mesh = 0; mesh < settings.models[heads[number].model].meshes; ++mesh)
      add_object(report, settings, counters, heads[number], number, mesh);
  }
  return report;
}

std::vector<GutterSize> gutters(const FrameSettings& settings, std::span<const passes::Head> heads) {
  std::vector<GutterSize> sizes;
  for (std::uint32_t mesh = 0; mesh < settings.skin.size(); ++mesh) {
    const PlannedMesh& part = settings.skin[mesh];
    const auto add = [&](std::uint32_t side) {
      const double texels_per_mm = std::max(part.max_uv_per_mm * side, 1e-6);
      sizes.push_back({.mesh = mesh, .side = side, .width_texels = seam_width(part.profile, texels_per_mm)});
    };

    add(settings.most_side);  // of the stretch map
    for (const passes::Head& head : heads) {
      const Model& model = settings.models[head.model];
      const bool has_mesh = mesh >= model.first_mesh && mesh - model.first_mesh < model.meshes;
      if (has_mesh && head.visible) add(head.detail.side);
    }
  }
  return sizes;
}

}  // namespace dermis::techniques::papers
