// SPDX-License-Identifier: MIT
// The profile of the public interface and the sum of Gaussians that the house computes with.
#pragma once

#include <string>

#include "dermis/profile.h"
#include "gaussians/sum.h"

namespace dermis::gaussians {

/// Returns the profile as a sum. Throws InputError, whose place is `where` (else "profile 'NAME'"), for all
/// that check_profile() of dermis/profile.h refuses.
SumOfGaussians checked_sum(const ScatterProfile& profile, const std::string& where = {});

/// Returns the sum as a profile: without a table of its model, and with model_total = total_reflectance.
ScatterProfile scatter_profile(const SumOfGaussians& sum);

}  // namespace dermis::gaussians
