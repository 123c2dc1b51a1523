// SPDX-License-Identifier: MIT
// The medium of a profile, in its file: "medium" {sigma_a_per_mm [3],
// sigma_s_per_mm [3], g, eta}. Beside it "shape", the laws of ShapeLaws by the names of their members, each
// [3].
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/json/value.h"
#include "tissue/gaussians/sum.h"

namespace dermis::gaussians {

/// Reads "medium" and "shape" of a profile, if they are there; a medium without laws gets its own. Throws
/// InputError: a key that is not known or missing, a value out of range, laws without a medium.
void read_shape(const json::Value& profile, ScatterProfile& sum);

/// Adds them, if the sum has them.
void write_shape(nlohmann::ordered_json& profile, const ScatterProfile& sum);

/// Throws InputError, whose place is `where`, for laws that no picture can be made with.
void check_shape(const ShapeLaws& shape, const std::string& where);

}  // namespace dermis::gaussians
