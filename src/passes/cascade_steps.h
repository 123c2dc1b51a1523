// SPDX-License-Identifier: MIT
/// The steps of a cascade of blurs: which Gaussians are blurred on which level of a pyramid of light maps.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "passes/cascade_level_io.h"

namespace dermis::passes {

/// How densely skin fills its map at T_max.
struct CascadeDensity {
  double max_texels_per_mm = 1;     ///< in the densest direction; a twentieth of the skin has more
  double mean_texels_per_mm = 1;    ///< geometric mean of both directions
  double coarse_texels_per_mm = 1;  ///< in the coarsest direction; a quarter of the skin has fewer
};

/// A step blurs all light of its term and of wider ones.
struct CascadeStep {
  double variance_mm2 = 0;              ///< of this step
  double total_mm2 = 0;                 ///< of this one and all narrower: what is left to do before it
  std::uint32_t halvings = 0;           ///< of its maps, at T_max; never falls towards wider steps
  std::uint32_t halvings_after = 0;     ///< of the next narrower term; 0 for the narrowest
  double share = 1;                     ///< of the variance between both terms, in this step
  double share_done = 1;                ///< in this step and all narrower of the same term
  std::optional<std::uint32_t> term{};  ///< whose light joins before this step
};

/// Widest sigma, in texels at the mean density, that is spread from the light itself by the sum at the end.
/// Its kernels of 5 x 5 taps have the right variance up to 1.35 texels: where skin is nearly twice as dense,
/// too.
inline constexpr double narrow_sigma = 0.75;
/// Least sigma, in texels of a level, of a term that is kept there.
inline constexpr double level_sigma = 1.0;

/// Returns how many terms, from the narrowest, one pass spreads from the light itself: at most `most`.
/// variances_mm2: narrow to wide.
std::uint32_t narrow_terms(const std::vector<double>& variances_mm2, double mean_texels_per_mm,
                           std::uint32_t most);

/// Returns the steps of the terms from `first_wide` on, narrow to wide; the device runs them from the last to
/// the first. `most_halvings`: of the coarsest level there is.
///
/// A term lies on the coarsest level on which its sigma, in the coarsest direction, is at least level_sigma
/// texels, and where the variance of its step is larger than what moving light between the levels adds. Steps
/// are split as those of blur_steps() are, so that the taps of a wide step never skip light: what follows
/// blurs by at least half of its sigma, or taps lie on whole texels of the level.
std::vector<CascadeStep> cascade_steps(const std::vector<double>& variances_mm2, std::uint32_t first_wide,
                                       const CascadeDensity& density, std::uint32_t most_halvings);

/// Returns the variance along u and v alike that light gets on its way from the largest map to one with
/// `ratio` times fewer texels per side and back, texels^2 of the largest map. Down by [1 3 3 1] / 8 and up by
/// [1 3] / 4, each half adds 0.75 texels^2 of the finer map.
inline double moved_texels2(double ratio) { return 0.5 * (ratio * ratio - 1); }

/// Returns the halvings of the maps to which light moves from those of `halvings`: where a head has its next
/// narrower step, else 0. first_step: as MappedTerms.
std::uint32_t level_after(const std::vector<CascadeStep>& steps, std::uint32_t first_step,
                          std::uint32_t halvings);

/// Returns the terms that a head blurs on maps of these halvings: their steps take off what moving adds, one
/// after the other, as far as they can (cascade_level.glsl). ratio, ratio_after: texels of the largest map
/// per texel of these maps and of those of level_after(). Lengths are in texels of the map on which the
/// result is used; ratio_here: as ratio, of that map. weights: one per term, mean of the channels.
io::CascadeLevelIo cascade_level(const std::vector<CascadeStep>& steps, std::uint32_t first_step,
                                 std::uint32_t halvings, const std::vector<float>& weights, double ratio,
                                 double ratio_after, double ratio_here);

/// Returns how many terms of a level lie before that of a step: MOST_LEVEL_TERMS - 1 at most.
std::uint32_t terms_before(const std::vector<CascadeStep>& steps, std::uint32_t first_step,
                           std::uint32_t number);

}  // namespace dermis::passes
