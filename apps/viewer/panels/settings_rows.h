// SPDX-License-Identifier: MIT
/// The rows of a section of the settings.
#pragma once

#include <string_view>

#include "viewer/panels/desk.h"

namespace dermis::viewer {

/// Draws all settings of a section ("camera"), but for those that have a place of their own.
void settings_rows(Desk& desk, std::string_view section);

}  // namespace dermis::viewer
