// SPDX-License-Identifier: MIT
/// The cascade of a skin mesh: passes/cascade/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "passes/cascade_steps.h"
#include "techniques/technique.h"

namespace dermis::techniques {

/// Of one skin mesh, at T_max.
struct CascadePlan {
  std::vector<double> variances_mm2;       ///< of the terms, narrow to wide
  std::vector<passes::CascadeStep> steps;  ///< narrow to wide
  std::vector<std::size_t> groups;         ///< first terms: passes::transmission_groups()
  std::uint32_t most_narrow = 0;           ///< terms that the sum may spread by itself

  /// Returns the group of the light that joins before a step; 0 where none does.
  std::size_t group_of(const passes::CascadeStep& step) const;
  /// Returns the first step that blurs more than `variance_mm2`.
  std::uint32_t first_step_over(double variance_mm2) const;
};
CascadePlan cascade_plan(const FrameSettings& settings, const SkinPart& part);

}  // namespace dermis::techniques
