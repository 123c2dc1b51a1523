// SPDX-License-Identifier: MIT
/// Look of panels.
#pragma once

namespace dermis::viewer {

/// Sets colours, sizes and the font of the current ImGui context. `scale`: pixels per pixel of 96 dpi.
void set_style(double scale);

}  // namespace dermis::viewer
