// SPDX-License-Identifier: MIT
// What the rows say of values, held against settings.
#pragma once

#include "dermis/settings.h"

namespace dermis {

/// InputError names the setting, its range and the value: "camera.fov_deg must be 0.1 to 170 degrees, got
/// 300".
void check_ranges(const RenderSettings& settings);

}  // namespace dermis
