// SPDX-License-Identifier: MIT
// Sums of Gaussians that have a name, each with its source.
#pragma once

#include <string_view>
#include <vector>

#include "tissue/gaussians/sum.h"

namespace dermis::gaussians {

/// Returns the six-Gaussian skin set of [DLE07] (GPU Gems 3, ch. 14, table 14-1), weights normalised to
/// white: the default of every command.
ScatterProfile skin_six();

/// Returns the names that known() takes, in the order in which errors list them.
std::vector<std::string_view> known_names();
/// Returns a sum by name: "skin", or a medium that was measured ([JMLH01], [DJ05]; tissue/optics/presets.h),
/// fitted as `dermis profile --preset` does and kept to six digits. InputError (lists the names) if there is
/// none.
ScatterProfile known(std::string_view name);

}  // namespace dermis::gaussians
