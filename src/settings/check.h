// SPDX-License-Identifier: MIT
// What the rows say of values, held against settings.
#pragma once

#include <string>

#include "core/fields.h"
#include "dermis/reference.h"
#include "dermis/scene.h"
#include "dermis/settings.h"

namespace dermis {

/// InputError names the setting, its range and the value: "camera.fov_deg must be 0.1 to 170 degrees, got
/// 300".
void check_ranges(const RenderSettings& settings);
void check_ranges(const SceneOptions& options);
void check_ranges(const ReferenceSettings& settings);

/// "0.1 to 170 degrees"; empty if the row bounds nothing.
std::string range_text(const About& about);

}  // namespace dermis
