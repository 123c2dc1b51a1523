// SPDX-License-Identifier: MIT
// One homogeneous medium that stands for a profile: gives the lengths that tables and engines ask for, also
// where the skin has layers.
// Based on: [JMLH01] sec. 2.4
#pragma once

#include "tissue/optics/media.h"
#include "tissue/profile/radial.h"

namespace dermis::profile {

/// Returns the k [1/mm] at which R^ has fallen to half of R^(0), one over the typical reach. (The mean square
/// radius depends most on the faintest tail, and is negative where a colour channel has negative weights for
/// far-reaching wavelengths.)
double half_frequency_per_mm(const RadialProfile& profile);

/// Returns the medium (g = 0) whose classical dipole has the total and the half frequency of the profile.
/// Exact for a dipole. For other profiles it is a summary: its 1/sigma_t' and 1/sigma_tr are what "mean free
/// path" means for a stack. eta 1..3. Throws InputError if the profile is 0 everywhere.
optics::Medium equivalent_medium(const RadialProfile& profile, double eta);

}  // namespace dermis::profile
