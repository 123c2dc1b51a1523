// SPDX-License-Identifier: MIT
#pragma once

#include "dermis/profile.h"
#include "gaussians/sum.h"

namespace dermis::api {

/// Returns the profile as techniques take it. Throws InputError for one that is not valid; says what is
/// wrong.
gaussians::SumOfGaussians sum_of(const ScatterProfile& profile);

}  // namespace dermis::api
