// SPDX-License-Identifier: MIT
#include "techniques/published/report.h"

#include <algorithm>

#include "techniques/mapped_terms.h"
#include "techniques/published/blur_io.h"
#include "techniques/published/kernels.h"

namespace dermis::techniques::papers {

Mask mask_of(const FrameSettings& settings) {
  if (!settings.optimise.cull && !settings.optimise.clip) return Mask::none;
  return settings.mask == BlurMask::alpha ? Mask::alpha : Mask::depth;
}

namespace {

// Adds what a skin mesh of a head has taken.
void add_object(FrameReport& report, const FrameSettings& settings, std::span<const std::uint32_t> counters,
                const DrawnHead& head, std::uint32_t mesh_in_model) {
  const std::uint32_t mesh = settings.models[head.model].first_mesh + mesh_in_model;
  const SkinPart& part = settings.skin[mesh];
  const passes::MappedTerms mapped = mapped_terms(settings, mesh, head.side);
  const auto counted = [&](ObjectCounter which) -> std::uint64_t {
    return counters[object_counter(settings, head.head, mesh_in_model, which)];
  };

  std::uint64_t convolutions = 0, terms = 0;
  std::uint32_t number = 0;
  for (const Step& step : steps_of(part.profile, part.max_texels_per_mm)) {
    if (!mapped.any || number++ < mapped.first_step) continue;
    convolutions += 2;
    if (step.ends_term) ++terms;
  }

  // With the alpha test fragments without light end early, but they start.
  const std::uint64_t at_once = mask_of(settings) == Mask::depth ? counted(counter_masked_texels)
                                                                 : std::uint64_t{head.side} * head.side;
  report.irradiance_texels += counted(counter_lit_texels);
  report.convolved_texels += counted(counter_lit_texels) * terms;
  report.launched += counted(counter_lit_texels) + at_once * convolutions;
  report.light_reads += at_once * convolutions * (2 * PAPER_TAPS + 1);
}

}  // namespace

FrameReport report(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                   std::span<const DrawnHead> drawn) {
  DERMIS_ASSERT_EQ(counters.size(), counter_count(settings));
  FrameReport report = screen_report(settings, counters, drawn);
  if (settings.optimise.cull) report.optimise.emplace_back("cull");
  if (settings.optimise.depth) report.optimise.emplace_back("depth");
  if (settings.optimise.clip) report.optimise.emplace_back("clip");
  if (mask_of(settings) != Mask::none) report.mask = mask_of(settings) == Mask::alpha ? "alpha" : "depth";
  report.maps = "full";
  report.unshaded_reads = counters[counter_unshaded_reads];
  report.transmission_misses = counters[counter_missed_light];

  for (const DrawnHead& head : drawn)
    for (std::uint32_t mesh = 0; mesh < settings.models[head.model].meshes; ++mesh)
      add_object(report, settings, counters, head, mesh);
  return report;
}

std::vector<GutterSize> gutters(const FrameSettings& settings, std::span<const DrawnHead> drawn) {
  std::vector<GutterSize> sizes;
  for (std::uint32_t mesh = 0; mesh < settings.skin.size(); ++mesh) {
    const SkinPart& part = settings.skin[mesh];
    const std::vector<Step> steps = steps_of(part.profile, part.max_texels_per_mm);
    const auto add = [&](std::uint32_t side) {
      const passes::MappedTerms mapped = mapped_terms(settings, mesh, side);
      const bool begins_later = mapped.any && mapped.first_step > 0;
      const double texels_per_mm = std::max(part.max_uv_per_mm * side, 1e-6);
      const double first_mm2 = begins_later ? steps[mapped.first_step].total_mm2 : 0;
      sizes.push_back(
          {.mesh = mesh, .side = side, .width_texels = seam_width(part.profile, texels_per_mm, first_mm2)});
    };

    add(settings.map_size);  // of the stretch map
    for (const DrawnHead& head : drawn) {
      const Model& model = settings.models[head.model];
      const bool has_mesh = mesh >= model.first_mesh && mesh - model.first_mesh < model.meshes;
      if (has_mesh && mapped_terms(settings, mesh, head.side).any) add(head.side);
    }
  }
  return sizes;
}

}  // namespace dermis::techniques::papers
