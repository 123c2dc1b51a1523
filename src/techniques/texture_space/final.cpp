// SPDX-License-Identifier: MIT
#include "techniques/texture_space/final.h"

#include <algorithm>
#include <cmath>

#include "passes/final_pass/final_pass.h"
#include "passes/scatter_sum/scatter_sum.h"
#include "techniques/texture_space/counters.h"

namespace dermis::techniques {
namespace {

std::vector<std::array<float, 3>> weights(const gaussians::SumOfGaussians& profile) {
  std::vector<std::array<float, 3>> w;
  for (const gaussians::Gaussian& term : profile.terms)
    w.push_back({static_cast<float>(term.weight[0]), static_cast<float>(term.weight[1]),
                 static_cast<float>(term.weight[2])});
  return w;
}

std::vector<float> sigmas_mm(const gaussians::SumOfGaussians& profile) {
  std::vector<float> sigmas;
  for (const gaussians::Gaussian& term : profile.terms)
    sigmas.push_back(static_cast<float>(std::sqrt(term.variance_mm2)));
  return sigmas;
}

// Returns the maps that hold the light of a profile of `count` terms: one each, or that of their sum.
std::vector<frame::TextureId> read_maps(const FrameSettings& settings, const LightMaps& maps,
                                        std::ptrdiff_t count) {
  if (settings.cascade) return maps.blurred();
  return {maps.blurred().begin(), maps.blurred().begin() + count};
}

std::vector<std::uint32_t> read_halvings(const FrameSettings& settings, const LightMaps& maps,
                                         std::ptrdiff_t count) {
  if (settings.cascade) return std::vector<std::uint32_t>(static_cast<std::size_t>(count), 0);
  return {maps.halvings().begin(), maps.halvings().begin() + count};
}

}  // namespace

void add_scatter_sum(passes::FramePlan& plan, const FrameSettings& settings, const LightMaps& maps,
                     frame::TextureId sum, const passes::MapSquare& square) {
  const SkinPart& part = settings.skin[square.mesh];
  const auto count = static_cast<std::ptrdiff_t>(part.profile.terms.size());
  plan.add<passes::ScatterSum>(
      label("scatter sum", settings, square.instance, square.mesh), {read_maps(settings, maps, count), sum},
      {.square = square,
       .weights = settings.cascade ? std::vector(1, std::array{1.0f, 1.0f, 1.0f}) : weights(part.profile),
       .halvings = read_halvings(settings, maps, count)});
}

void add_final(passes::FramePlan& plan, const FrameSettings& settings, Screen& screen, const LightMaps& maps,
               const passes::MapSquare& square) {
  if (!settings.draws_picture()) return;
  const SkinPart& part = settings.skin[square.mesh];
  const auto count = static_cast<std::ptrdiff_t>(part.profile.terms.size());
  const passes::TermsOnMap terms{.sigmas_mm = sigmas_mm(part.profile),
                                 .even_uv_per_mm = static_cast<float>(part.even_uv_per_mm),
                                 .largest_side = settings.map_size,
                                 .coarse = part.coarse && !settings.host_lights()};

  plan.add<passes::FinalPass>(
      label("final", settings, square.instance, square.mesh),
      {read_maps(settings, maps, count), screen.shadow(), screen.colour(), screen.depth(), screen.entering()},
      {.square = square,
       .samples = settings.samples,
       .format = settings.picture_format(),
       .clear = screen.take_clear(),
       .weights = weights(part.profile),
       .halvings = read_halvings(settings, maps, count),
       .summed = settings.cascade,
       .environment = settings.environment,
       .soft_shadows = settings.soft_shadows,
       .off_map = part.off_map,
       .cut_out = part.cut_out,
       .emits = part.emits,
       .mixes = settings.mixes(),
       .terms = terms,
       .texels_per_mm = static_cast<float>(part.mean_texels_per_mm),
       .through = settings.translucency
                      ? std::optional(passes::ThroughMesh{square.mesh, part.profile, part.mm_per_unit})
                      : std::nullopt});

  if (settings.host) return;

  if (settings.cascade) {
    plan.add<passes::UnshadedReads>(label("count unshaded reads", settings, square.instance, square.mesh),
                                    {maps.blurred(), screen.depth(), screen.counters()},
                                    {.square = square,
                                     .samples = settings.samples,
                                     .cut_out = part.cut_out,
                                     .slot = counter_unshaded_reads,
                                     .terms = terms,
                                     .first_term = MOST_TERMS});
    return;
  }

  // A short profile does not reach the small maps of a longer one beside it.
  for (const Level& level : maps.levels()) {
    const auto first = std::find(maps.halvings().begin(), maps.halvings().end(), level.halvings);
    if (first - maps.halvings().begin() >= count) continue;
    plan.add<passes::UnshadedReads>(
        label(at("count unshaded reads", level), settings, square.instance, square.mesh),
        {level.blurred, screen.depth(), screen.counters()},
        {.square = on_level(square, level),
         .samples = settings.samples,
         .cut_out = part.cut_out,
         .slot = counter_unshaded_reads,
         .terms = terms,
         .first_term = level.first_term});
  }
}

}  // namespace dermis::techniques
