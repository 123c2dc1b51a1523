// SPDX-License-Identifier: MIT
#include "techniques/cascade_plan.h"

#include <algorithm>

#include "passes/cascade/cascade_io.h"
#include "passes/downsample/downsample.h"
#include "passes/transmission.h"

namespace dermis::techniques {

CascadePlan cascade_plan(const FrameSettings& settings, const SkinPart& part) {
  CascadePlan plan;
  for (const gaussians::Gaussian& term : part.profile.terms) plan.variances_mm2.push_back(term.variance_mm2);

  // Of narrow terms, transmitted light of the second group is there at the sum, and no other.
  plan.groups = passes::transmission_groups(plan.variances_mm2.size());
  plan.most_narrow = MOST_NARROW;
  if (settings.translucency && plan.groups.size() > 2)
    plan.most_narrow = std::min<std::uint32_t>(MOST_NARROW, static_cast<std::uint32_t>(plan.groups[2]));

  std::uint32_t most_halvings = 0;
  while (most_halvings < passes::max_halvings && settings.map_size % (2u << most_halvings) == 0)
    ++most_halvings;
  const std::uint32_t narrow =
      passes::narrow_terms(plan.variances_mm2, part.mean_texels_per_mm, plan.most_narrow);
  plan.steps = passes::cascade_steps(plan.variances_mm2, narrow,
                                     {.max_texels_per_mm = part.max_texels_per_mm,
                                      .mean_texels_per_mm = part.mean_texels_per_mm,
                                      .coarse_texels_per_mm = part.coarse_texels_per_mm},
                                     most_halvings);
  return plan;
}

std::size_t CascadePlan::group_of(const passes::CascadeStep& step) const {
  if (!step.term) return 0;
  std::size_t group = 0;
  while (group + 1 < groups.size() && groups[group + 1] <= *step.term) ++group;
  return group;
}

std::uint32_t CascadePlan::first_step_over(double variance_mm2) const {
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const passes::CascadeStep& step) {
    return step.total_mm2 > variance_mm2 * (1 + 1e-9);
  });
  return static_cast<std::uint32_t>(found - steps.begin());
}

}  // namespace dermis::techniques
