// SPDX-License-Identifier: MIT
#include "render/techniques/texture_space/final.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "frame/together.h"
#include "render/passes/scatter/scatter_sum/scatter_sum.h"
#include "render/techniques/texture_space/counters.h"

namespace dermis::techniques {

using frame::Together;

namespace {

// A sigma of 0 says that light is not blurred: none of a Gaussian rounds to it.
passes::MapTerm map_term(const Gaussian& term) {
  return {.weight = {term.weight[0], term.weight[1], term.weight[2]},
          .sigma_mm =
              std::max(static_cast<float>(std::sqrt(term.variance_mm2)), std::numeric_limits<float>::min())};
}

SkinOnScreen skin_of(const FrameSettings& settings, const LightMaps& maps, const passes::MapSquare& square) {
  const PlannedMesh& part = settings.skin[square.mesh];
  SkinOnScreen skin{.look = {.square = square,
                             .terms = {},
                             .mixes = settings.mixes(),
                             .unscattered = part.unscattered != gaussians::Rgb{},
                             .shape = part.profile.shape,
                             .mm_per_unit = part.mm_per_unit,
                             .through = {}},
                    .maps = {}};
  if (settings.translucency) skin.look.through = part.through(square.mesh);
  for (const Gaussian& term : part.mapped()) {
    skin.maps.push_back(maps.blurred()[skin.maps.size()]);
    skin.look.terms.push_back(map_term(term));
  }
  if (!part.reads_entered) return skin;

  passes::MapTerm narrow;
  for (const Gaussian& term : std::span(part.profile.terms).first(part.first_mapped))
    narrow.weight += map_term(term).weight;
  skin.look.terms.push_back(narrow);
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
                            {.square = square, .terms = skin.look.terms, .mixes = skin.look.mixes}});
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
