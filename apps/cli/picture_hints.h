// SPDX-License-Identifier: MIT
#pragma once

#include "dermis/renderer.h"

namespace dermis::cli {

/// Warns, in one line each, where a picture shows no skin although the scene has some, and where `display` is
/// true and most of the skin is over white: with the exposure that would be right.
void hint_at_picture(const Picture& picture, bool display);

}  // namespace dermis::cli
