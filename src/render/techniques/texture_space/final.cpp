// SPDX-License-Identifier: MIT
#include "render/techniques/texture_space/final.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "frame/together.h"
#include "render/passes/scatter/scatter_sum/scatter_sum.h"
#include "render/techniques/texture_space/counters.h"

namespace dermis::techniques {

using frame::Together;

namespace {

std::vector<std::array<float, 3>> weights(std::span<const Gaussian> terms) {
  std::vector<std::array<float, 3>> w;
  for (const Gaussian& term : terms)
    w.push_back({static_cast<float>(term.weight[0]), static_cast<float>(term.weight[1]),
                 static_cast<float>(term.weight[2])});
  return w;
}

std::vector<float> sigmas_mm(std::span<const Gaussian> terms) {
  std::vector<float> sigmas;
  for (const Gaussian& term : terms) sigmas.push_back(static_cast<float>(std::sqrt(term.variance_mm2)));
  return sigmas;
}

// Returns the maps that hold the light of a profile, one per term.
std::vector<frame::TextureId> read_maps(const LightMaps& maps, const PlannedMesh& part) {
  const auto count = static_cast<std::ptrdiff_t>(part.mapped_count());
  return {maps.blurred().begin(), maps.blurred().begin() + count};
}

passes::TermsOnMap terms_on_map(const PlannedMesh& part) {
  return {
      .sigmas_mm = sigmas_mm(part.mapped()), .shape = part.profile.shape, .mm_per_unit = part.mm_per_unit};
}

SkinOnScreen skin_of(const FrameSettings& settings, const LightMaps& maps, const passes::MapSquare& square) {
  const PlannedMesh& part = settings.skin[square.mesh];
  std::optional<passes::ThroughMesh> through;
  if (settings.translucency) through = part.through(square.mesh);

  SkinOnScreen skin{.look = {.square = square,
                             .weights = weights(part.mapped()),
                             .entered = part.reads_entered,
                             .mixes = settings.mixes(),
                             .unscattered = part.unscattered != gaussians::Rgb{},
                             .terms = terms_on_map(part),
                             .through = std::move(through)},
                    .maps = read_maps(maps, part)};
  if (!skin.look.entered) return skin;
  std::array<float, 3> narrow{};
  for (const std::array<float, 3>& weight : weights(std::span(part.profile.terms).first(part.first_mapped)))
    for (std::size_t c = 0; c < 3; ++c) narrow[c] += weight[c];
  skin.look.weights.push_back(narrow);
  skin.look.terms.sigmas_mm.push_back(0);
  skin.maps.push_back(maps.entered());
  return skin;
}

}  // namespace

void add_scatter_sum(passes::FramePlan& plan, const FrameSettings& settings, const LightMaps& maps,
                     frame::TextureId sum, const std::vector<passes::MapSquare>& squares) {
  Together<passes::ScatterSum>::In sums;
  for (const passes::MapSquare& square : squares) {
    const SkinOnScreen skin = skin_of(settings, maps, square);
    sums.members.push_back({{skin.maps, maps.stretch(square.mesh), sum},
                            {.square = square,
                             .weights = skin.look.weights,
                             .sigmas_mm = skin.look.terms.sigmas_mm,
                             .entered = skin.look.entered,
                             .mixes = skin.look.mixes}});
  }
  plan.add<Together<passes::ScatterSum>>(maps.name("scatter sum"), sums);
}

void add_final(const FrameSettings& settings, Screen& screen, const LightMaps& maps,
               const std::vector<passes::MapSquare>& squares) {
  if (!settings.draws_picture() || squares.empty()) return;

  std::vector<SkinOnScreen> skin;
  for (const passes::MapSquare& square : squares) skin.push_back(skin_of(settings, maps, square));
  screen.add_unshaded_reads(skin, counter_unshaded_reads, maps.name("count unshaded reads"));
  screen.add_skin(skin, maps.name("shade"));
}

}  // namespace dermis::techniques
