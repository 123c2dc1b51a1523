// SPDX-License-Identifier: MIT
// One homogeneous medium that stands for a profile: the lengths that tables and engines ask for, also where the skin has layers.
// Based on: [JMLH01] sec. 2.4
#pragma once

#include "optics/media.h"
#include "profile/radial.h"

namespace dermis::profile {

/// <r^2> = Int r^2 R 2 pi r dr / total [mm^2], from the curvature of R^ at k = 0: R^ = total (1 - k^2 <r^2> / 4 + ...).
double mean_square_radius_mm2(const RadialProfile& profile);

/// The medium (g = 0) whose classical dipole has the total and the <r^2> of the profile. Exact for a dipole; else a summary:
/// its 1/sigma_t' and 1/sigma_tr are what "mean free path" means for a stack. eta 1..3. InputError if the profile is 0 everywhere.
optics::Medium equivalent_medium(const RadialProfile& profile, double eta);

}  // namespace dermis::profile
