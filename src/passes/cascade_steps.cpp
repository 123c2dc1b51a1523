// SPDX-License-Identifier: MIT
#include "passes/cascade_steps.h"

#include <algorithm>
#include <cmath>

#include "passes/kernels.h"

namespace dermis::passes {
namespace {

// Returns the coarsest level for a term; see cascade_steps().
std::uint32_t level_of(double variance_mm2, double before_mm2, std::uint32_t before_halvings,
                       double coarse_texels_per_mm, std::uint32_t most_halvings) {
  const double sigma_texels = std::sqrt(variance_mm2) * coarse_texels_per_mm;
  std::uint32_t halvings = before_halvings;
  while (halvings < most_halvings && sigma_texels >= level_sigma * (2u << halvings)) ++halvings;

  const double step_texels2 = (variance_mm2 - before_mm2) * coarse_texels_per_mm * coarse_texels_per_mm;
  const auto added = [&](std::uint32_t n) {
    return moved_texels2(1u << n) - moved_texels2(1u << before_halvings);
  };
  while (halvings > before_halvings && step_texels2 <= added(halvings)) --halvings;
  return halvings;
}

}  // namespace

std::uint32_t narrow_terms(const std::vector<double>& variances_mm2, double mean_texels_per_mm,
                           std::uint32_t most) {
  std::uint32_t count = 0;
  while (count < most && count < variances_mm2.size() &&
         std::sqrt(variances_mm2[count]) * mean_texels_per_mm <= narrow_sigma)
    ++count;
  return count;
}

std::vector<CascadeStep> cascade_steps(const std::vector<double>& variances_mm2, std::uint32_t first_wide,
                                       const CascadeDensity& density, std::uint32_t most_halvings) {
  std::vector<CascadeStep> steps;
  double before_mm2 = 0;
  std::uint32_t before_halvings = 0;

  for (std::uint32_t term = first_wide; term < variances_mm2.size(); ++term) {
    const double variance_mm2 = variances_mm2[term], all_mm2 = variance_mm2 - before_mm2;
    const std::uint32_t halvings =
        level_of(variance_mm2, before_mm2, before_halvings, density.coarse_texels_per_mm, most_halvings);
    const double dense_mm = RATIO_MAX_SIGMA * (1u << halvings) / density.max_texels_per_mm;

    double done_mm2 = before_mm2;
    const auto add = [&](double end_mm2, std::optional<std::uint32_t> joins) {
      steps.push_back({.variance_mm2 = end_mm2 - done_mm2,
                       .total_mm2 = end_mm2,
                       .halvings = halvings,
                       .halvings_after = before_halvings,
                       .share = all_mm2 > 0 ? (end_mm2 - done_mm2) / all_mm2 : 1,
                       .share_done = all_mm2 > 0 ? (end_mm2 - before_mm2) / all_mm2 : 1,
                       .term = joins});
      done_mm2 = end_mm2;
    };
    while (true) {
      const double limit_mm2 = std::max(4 * done_mm2, done_mm2 + dense_mm * dense_mm);
      if (variance_mm2 <= limit_mm2 * (1 + 1e-9)) break;
      add(limit_mm2, {});
    }
    add(variance_mm2, term);

    before_mm2 = variance_mm2;
    before_halvings = halvings;
  }
  return steps;
}

std::uint32_t level_after(const std::vector<CascadeStep>& steps, std::uint32_t first_step,
                          std::uint32_t halvings) {
  std::uint32_t after = 0;
  for (std::uint32_t i = first_step; i < steps.size(); ++i)
    if (steps[i].halvings < halvings) after = std::max(after, steps[i].halvings);
  return after;
}

std::uint32_t terms_before(const std::vector<CascadeStep>& steps, std::uint32_t first_step,
                           std::uint32_t number) {
  std::uint32_t count = 0;
  for (std::uint32_t i = first_step; i < number; ++i)
    if (steps[i].halvings == steps[number].halvings && steps[i].term) ++count;
  return std::min<std::uint32_t>(count, MOST_LEVEL_TERMS - 1);
}

io::CascadeLevelIo cascade_level(const std::vector<CascadeStep>& steps, std::uint32_t first_step,
                                 std::uint32_t halvings, const std::vector<float>& weights, double ratio,
                                 double ratio_after, double ratio_here) {
  io::CascadeLevelIo level{};
  const double moved = moved_texels2(ratio) - moved_texels2(ratio_after);
  level.moved_texels2 = static_cast<float>(moved / (ratio_here * ratio_here));

  for (std::uint32_t i = first_step; i < steps.size(); ++i) {
    const CascadeStep& step = steps[i];
    if (step.halvings != halvings) continue;
    const std::uint32_t slot = terms_before(steps, first_step, i);
    if (level.terms == 0 && i > first_step)
      level.before_mm2 = static_cast<float>(step.total_mm2 - step.variance_mm2);
    level.terms = slot + 1;
    level.steps_mm2[slot] += static_cast<float>(i == first_step ? step.total_mm2 : step.variance_mm2);
    if (step.term) level.weights[slot] += weights[*step.term];
  }
  return level;
}

}  // namespace dermis::passes
