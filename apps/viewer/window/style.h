// SPDX-License-Identifier: MIT
/// How panels look.
#pragma once

namespace dermis::viewer {

/// Sets colours, sizes and the font of the current ImGui context. `scale`: pixels per pixel of 96 dpi.
void set_style(double scale);

}  // namespace dermis::viewer
