// SPDX-License-Identifier: MIT
// Three profiles as a table of R(r).
#pragma once

#include <array>

#include "dermis/profile.h"
#include "tissue/profile/radial.h"

namespace dermis::profile {

/// Returns R(r) of each channel and its standard error, at radii that
/// leave out 1e-3 of the light at most. Counts steps (base/core/hooks.h).
ProfileTable table_of(const std::array<ProfilePtr, 3>& profiles);

}  // namespace dermis::profile
