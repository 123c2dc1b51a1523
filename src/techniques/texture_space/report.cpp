// SPDX-License-Identifier: MIT
#include "techniques/texture_space/report.h"

#include <algorithm>
#include <array>

#include "passes/blur/blur.h"
#include "passes/kernels.h"
#include "shared/tiles_io.h"
#include "techniques/cascade_plan.h"
#include "techniques/mapped_terms.h"
#include "techniques/texture_space/counters.h"
#include "techniques/texture_space/light_maps.h"

namespace dermis::techniques {
namespace {

constexpr std::uint32_t levels = passes::max_halvings + 1;

// What runs over the squares of one skin mesh in maps of one size.
struct LevelWork {
  std::uint32_t terms = 0;         // Gaussians that end there
  std::uint32_t convolutions = 0;  // passes, both axes counted
  std::uint32_t moves = 0;         // passes that bring light from maps of another size
  bool halved = false;             // the level is made by Downsample
};
using Work = std::array<LevelWork, levels>;  // by halvings

// Follows the steps of Convolution (convolution.cpp) for a head, and counts instead of adding passes.
Work chain_work_of(const SkinPart& part, const passes::MappedTerms& mapped) {
  Work work{};
  if (!mapped.any) return work;

  std::size_t number = 0;
  for (const passes::BlurStep& step : passes::blur_steps(part.profile, part.max_texels_per_mm)) {
    if (number++ < mapped.first_step) continue;
    work[0].convolutions += 2;
    if (step.ends_term) ++work[0].terms;
  }
  return work;
}

// Follows the steps of Cascade (cascade.cpp) likewise.
Work cascade_work_of(const FrameSettings& settings, const SkinPart& part, const passes::MappedTerms& mapped) {
  Work work{};
  if (!mapped.any) return work;
  const CascadePlan cascade = cascade_plan(settings, part);

  // One pyramid per group of transmitted light, as far as its terms reach; the first to the end.
  std::vector<std::uint32_t> coarsest(cascade.groups.size(), 0);
  for (const passes::CascadeStep& step : cascade.steps) {
    std::uint32_t& of_group = coarsest[settings.translucency ? cascade.group_of(step) : 0];
    of_group = std::max(of_group, step.halvings);
    coarsest[0] = std::max(coarsest[0], step.halvings);
  }
  for (const std::uint32_t most : coarsest)
    for (std::uint32_t halvings = 1; halvings <= most; ++halvings) {
      ++work[halvings].moves;
      work[halvings].halved = true;
    }

  for (std::uint32_t i = mapped.first_step; i < cascade.steps.size(); ++i) {
    const passes::CascadeStep& step = cascade.steps[i];
    work[step.halvings].convolutions += 2;
    if (step.term) ++work[step.halvings].terms;
    const std::uint32_t after = i == 0 ? 0 : cascade.steps[i - 1].halvings;
    for (std::uint32_t halvings = after; halvings < step.halvings; ++halvings) ++work[halvings].moves;
  }
  // The sum, which does the second axis of the last step if that is on its maps.
  const bool ends =
      mapped.first_step < cascade.steps.size() && cascade.steps[mapped.first_step].halvings == 0;
  if (!ends) ++work[0].convolutions;
  work[0].terms += mapped.first_wide - std::min(mapped.first_wide, mapped.first_read);
  return work;
}

Work work_of(const FrameSettings& settings, std::uint32_t mesh, const passes::MappedTerms& mapped) {
  const SkinPart& part = settings.skin[mesh];
  return settings.cascade ? cascade_work_of(settings, part, mapped) : chain_work_of(part, mapped);
}

double widest_step_mm2(const CascadePlan& cascade, const passes::MappedTerms& mapped) {
  double widest = 0;
  for (std::uint32_t i = mapped.first_step; i < cascade.steps.size(); ++i)
    widest =
        std::max(widest, i == mapped.first_step ? cascade.steps[i].total_mm2 : cascade.steps[i].variance_mm2);
  return widest;
}

// Returns the variance of the step with which the chain of a head starts that leaves narrow terms out; 0 if
// it leaves none out.
double first_variance_mm2(const FrameSettings& settings, const SkinPart& part,
                          const passes::MappedTerms& mapped) {
  if (settings.cascade) return widest_step_mm2(cascade_plan(settings, part), mapped);
  if (!mapped.any || mapped.first_step == 0) return 0;
  const std::vector<passes::BlurStep> steps = passes::blur_steps(part.profile, part.max_texels_per_mm);
  double sum = 0;
  for (std::size_t i = 0; i <= mapped.first_step; ++i) sum += steps[i].variance_mm2;
  return sum;
}

bool has_mesh(const Model& model, std::uint32_t mesh) {
  return mesh >= model.first_mesh && mesh - model.first_mesh < model.meshes;
}

// The figures of a frame from its counters; docs/measuring.md says what each means.
class Figures {
 public:
  Figures(const FrameSettings& settings, std::span<const std::uint32_t> counters,
          std::span<const DrawnHead> drawn)
      : settings_(settings), counters_(counters) {
    for (const DrawnHead& head : drawn)
      for (std::uint32_t i = 0; i < settings.models[head.model].meshes; ++i) add(head, i);
  }

  std::uint64_t irradiance_texels = 0;
  /// Texels lit by the mesh itself, times the Gaussians that blur them. In halved maps texels beside seams
  /// count too.
  std::uint64_t convolved_texels = 0;
  std::uint64_t launched = 0;  ///< shader invocations of shading, downsampling and convolution
  std::uint64_t taps = 0;      ///< of convolutions; those of a cascade differ from step to step, and are not

 private:
  // Adds what skin mesh `i` of a head has taken.
  void add(const DrawnHead& head, std::uint32_t i) {
    const std::uint32_t mesh = settings_.models[head.model].first_mesh + i;
    const Work work = work_of(settings_, mesh, mapped_terms(settings_, mesh, head.side));
    const auto counted = [&](std::uint32_t halvings, SquareCounter which) -> std::uint64_t {
      return counters_[square_counter(settings_, head.head, i, halvings, which)];
    };

    irradiance_texels += counted(0, counter_lit_texels);
    launched += counted(0, counter_lit_texels);
    for (std::uint32_t halvings = 0; halvings < levels; ++halvings) {
      const LevelWork& level = work[halvings];
      const std::uint64_t side = passes::halved_side(head.side, settings_.halving_side(), halvings);
      convolved_texels +=
          counted(halvings, halvings == 0 ? counter_lit_texels : counter_masked_texels) * level.terms;

      // Shader invocations of one convolution: what is not skipped of the used square.
      std::uint64_t at_once = side * side;
      if (is_sparse(settings_))
        at_once = std::uint64_t{TILE_WIDTH * TILE_HEIGHT} * counted(halvings, counter_tiles);
      launched += at_once * level.convolutions + side * side * level.moves;
      if (!settings_.cascade) taps += at_once * level.convolutions * (2 * passes::kernel_radius + 1);
    }
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
                                 std::span<const DrawnHead> drawn) {
  DERMIS_ASSERT_EQ(counters.size(), counter_count(settings));
  const Figures figures(settings, counters, drawn);

  FrameReport report = screen_report(settings, counters, drawn);
  report.optimise = names_of(settings.optimise);
  if (is_sparse(settings)) report.mask = "tiles";
  report.blur = settings.cascade ? "cascade" : "chain";
  report.translucency = settings.translucency;
  report.shape_aware = std::any_of(settings.skin.begin(), settings.skin.end(),
                                   [](const SkinPart& part) { return part.profile.shape.has_value(); });
  report.irradiance_texels = figures.irradiance_texels;
  report.convolved_texels = figures.convolved_texels;
  report.launched = figures.launched;
  report.light_reads = figures.taps;
  report.unshaded_reads = counters[counter_unshaded_reads];
  report.transmission_misses = counters[counter_transmission_misses];
  return report;
}

std::vector<GutterSize> texture_space_gutters(const FrameSettings& settings,
                                              std::span<const DrawnHead> drawn) {
  std::vector<GutterSize> sizes;

  for (std::uint32_t mesh = 0; mesh < settings.skin.size(); ++mesh) {
    const SkinPart& part = settings.skin[mesh];
    const auto add = [&](std::uint32_t side) {
      const double texels_per_mm = std::max(part.max_uv_per_mm * side, 1e-6);
      // A function of the side alone, also where the map is a halved one of a nearer head.
      const double first_mm2 = first_variance_mm2(settings, part, mapped_terms(settings, mesh, side));
      sizes.push_back({.mesh = mesh,
                       .side = side,
                       .width_texels = passes::gutter_width(part.profile, texels_per_mm, first_mm2)});
    };

    add(settings.map_size);  // of the stretch map
    for (const DrawnHead& head : drawn) {
      if (!has_mesh(settings.models[head.model], mesh)) continue;
      const passes::MappedTerms mapped = mapped_terms(settings, mesh, head.side);
      if (!mapped.any) continue;

      const Work work = work_of(settings, mesh, mapped);
      for (std::uint32_t level = 0; level < levels; ++level)
        if (level == 0 || work[level].halved)
          add(passes::halved_side(head.side, settings.halving_side(), level));
    }
  }
  return sizes;
}

}  // namespace dermis::techniques
