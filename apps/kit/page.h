// SPDX-License-Identifier: MIT
// A record of the kit as a page for people.
#pragma once

#include <string>
#include <vector>

#include "kit/measure.h"

namespace dermis::kit {

/// Returns a document that holds everything it shows. A picture that cannot be read is left out.
std::string page(const Json& record, const std::vector<Measurement::Shot>& shots);

}  // namespace dermis::kit
