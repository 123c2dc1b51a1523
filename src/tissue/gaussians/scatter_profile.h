// SPDX-License-Identifier: MIT
// Profiles of callers.
#pragma once

#include <string>

#include "dermis/profile.h"
#include "tissue/gaussians/sum.h"

namespace dermis::gaussians {

/// Returns the profile as the house computes with it: with the shape of its medium, and without what
/// profile_of_...() has added. Throws InputError, whose place is `where` (else "profile 'NAME'"), for all
/// that check_profile() of dermis/profile.h refuses.
ScatterProfile checked_profile(const ScatterProfile& profile, const std::string& where = {});

}  // namespace dermis::gaussians
