// SPDX-License-Identifier: MIT
#include "render/techniques/texture_space/report.h"

#include <algorithm>
#include <cmath>

#include "render/passes/scatter/blur/blur.h"
#include "render/shared/tiles_io.h"
#include "render/techniques/mapped_terms.h"
#include "render/techniques/texture_space/counters.h"
#include "render/techniques/texture_space/light_maps.h"

namespace dermis::techniques {
namespace {

// Work over the maps of one skin mesh of a head.
struct Work {
  std::uint32_t terms = 0;         // Gaussians that are blurred
  std::uint32_t convolutions = 0;  // passes, each axis counted
  std::uint32_t taps = 0;          // of these, where the unwrap has its mean density
};

// Follows the steps of add_convolution() for a head, and counts instead of adding passes.
Work work_of(const FrameSettings& settings, const PlannedMesh& part, std::uint32_t side,
             const passes::MappedTerms& mapped) {
  Work work;
  if (!mapped.any) return work;
  const std::size_t direct = direct_steps(settings, part);
  const double texels_per_mm = part.mean_uv_per_mm * side;
  double total_mm2 = 0;
  std::size_t number = 0;
  for (const passes::BlurStep& step : passes::blur_steps(part.mapped(), settings.chain_texels_per_mm(part))) {
    total_mm2 += step.variance_mm2;
    const bool from_light = number < direct || number == mapped.first_step;
    if (number++ < mapped.first_step) continue;
    // Along the first axis the next step from the light reads for this one, too.
    const std::uint32_t axes = number < direct ? 1 : 2;
    work.convolutions += axes;
    const double sigma_mm = std::sqrt(from_light ? total_mm2 : step.variance_mm2);
    work.taps += axes * static_cast<std::uint32_t>(passes::blur_taps(sigma_mm * texels_per_mm, from_light));
    if (step.ends_term) ++work.terms;
  }
  return work;
}

bool has_mesh(const Model& model, std::uint32_t mesh) {
  return mesh >= model.first_mesh && mesh - model.first_mesh < model.meshes;
}

// The figures of a frame from its counters; docs/methodology.md says what each means.
class Figures {
 public:
  Figures(const FrameSettings& settings, std::span<const std::uint32_t> counters,
          std::span<const passes::Head> heads)
      : settings_(settings), counters_(counters) {
    for (std::uint32_t number = 0; number < heads.size(); ++number) {
      if (!heads[number].visible) continue;
      for (std::uint32_t i = 0; i < settings.models[heads[number].model].meshes; ++i)
        add(heads[number], number, i);
    }
  }

  std::uint64_t irradiance_texels = 0;
  /// Texels lit by the mesh itself, times the Gaussians that blur them.
  std::uint64_t convolved_texels = 0;
  std::uint64_t launched = 0;  ///< shader invocations of shading and convolution
  std::uint64_t taps = 0;      ///< of convolutions

 private:
  // Adds what skin mesh `i` of head `number` has taken.
  void add(const passes::Head& head, std::uint32_t number, std::uint32_t i) {
    const std::uint32_t mesh = settings_.models[head.model].first_mesh + i;
    const Work work = work_of(settings_, settings_.skin[mesh], head.detail.side,
                              mapped_terms(settings_, mesh, head.detail));
    const auto counted = [&](SquareCounter which) -> std::uint64_t {
      return counters_[square_counter(settings_, number, i, which)];
    };

    // Shader invocations of one convolution: the tiles.
    const std::uint64_t at_once = std::uint64_t{TILE_SIDE * TILE_SIDE} * counted(counter_tiles);
    irradiance_texels += counted(counter_lit_texels);
    convolved_texels += counted(counter_lit_texels) * work.terms;
    launched += counted(counter_lit_texels) + at_once * work.convolutions;
    taps += at_once * work.taps;
  }

  const FrameSettings& settings_;
  std::span<const std::uint32_t> counters_;
};

std::vector<std::string> names_of(const Optimise& optimise) {
  std::vector<std::string> names;
  if (optimise.cull) names.emplace_back("cull");
  if (optimise.depth) names.emplace_back("depth");
  if (optimise.clip) names.emplace_back("clip");
  return names;
}

}  // namespace

FrameReport texture_space_report(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                                 std::span<const passes::Head> heads) {
  DERMIS_ASSERT_EQ(counters.size(), counter_count(settings));
  const Figures figures(settings, counters, heads);

  FrameReport report = screen_report(settings, counters, heads);
  report.optimise = names_of(settings.optimise);
  if (settings.optimise.cull || settings.optimise.clip) report.mask = "tiles";
  report.translucency = settings.translucency;
  report.shape_aware = std::any_of(settings.skin.begin(), settings.skin.end(),
                                   [](const PlannedMesh& part) { return part.profile.shape.has_value(); });
  report.irradiance_texels = figures.irradiance_texels;
  report.convolved_texels = figures.convolved_texels;
  report.launched = figures.launched;
  report.light_reads = figures.taps;
  report.unshaded_reads = counters[counter_unshaded_reads];
  report.transmission_misses = counters[counter_transmission_misses];
  return report;
}

std::vector<GutterSize> texture_space_gutters(const FrameSettings& settings,
                                              std::span<const passes::Head> heads) {
  std::vector<GutterSize> sizes;

  for (std::uint32_t mesh = 0; mesh < settings.skin.size(); ++mesh) {
    const PlannedMesh& part = settings.skin[mesh];
    const auto add = [&](std::uint32_t side) {
      sizes.push_back({.mesh = mesh,
                       .side = side,
                       .width_texels = passes::gutter_width(part.profile, part.max_texels_per_mm(side))});
    };

    add(settings.stretch_side);
    for (const passes::Head& head : heads)
      if (head.visible && has_mesh(settings.models[head.model], mesh) &&
          mapped_terms(settings, mesh, head.detail).any)
        add(head.detail.side);
  }
  return sizes;
}

}  // namespace dermis::techniques
