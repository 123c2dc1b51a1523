// SPDX-License-Identifier: MIT
/// The background, by its name.
#pragma once

#include <string>

#include "render/passes/pixels/behind.h"

namespace dermis::setup {

/// Returns what the setting output.background names. Throws InputError unless it is black, studio,
/// environment or #RRGGBB.
passes::Behind background_of(const std::string& name);

}  // namespace dermis::setup
