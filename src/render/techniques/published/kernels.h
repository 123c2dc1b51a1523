// SPDX-License-Identifier: MIT
/// Kernels of the convolutions, and the steps in which a profile is convolved.
#pragma once

#include <vector>

#include "tissue/gaussians/sum.h"

namespace dermis::techniques::papers {

/// Returns two tables of PAPER_ROWS rows of PAPER_ROW_FLOATS floats. The first has Gaussians sampled at whole
/// texels, whose variance is exact. The second is for the first step, whose input is constant over each
/// texel: means over texels of the light of a neighbouring texel of unit light. Made once.
const std::vector<float>& kernel_table();

/// One convolution along both axes.
struct Step {
  double variance_mm2 = 0;  ///< that it adds
  bool ends_term = false;   ///< the light after it is that of a term of the profile
};

/// Returns the steps of a profile, narrow to wide: Gaussians compose, so each term starts from the one before
/// ([DLE07] sec. 3.3, G(v1) * G(v2) = G(v1 + v2)). Departure: where terms are so far apart that sigma would
/// more than double, steps between them are added, or taps would be further apart than the light is smooth.
/// The first is at most two texels wide where the map is densest.
std::vector<Step> steps_of(const ScatterProfile& profile, double max_texels_per_mm);

/// Returns how many texels beside a seam the widest step reads, at most 96.
int seam_width(const ScatterProfile& profile, double max_texels_per_mm);

}  // namespace dermis::techniques::papers
