// SPDX-License-Identifier: MIT
/// Where everything is in the window: the picture, the panels at its right, a line below.
#pragma once

#include <string>
#include <vector>

#include "viewer/panels/desk.h"
#include "viewer/window/window.h"

namespace dermis::viewer {

/// Of the picture, pixels of the display.
struct PictureArea {
  int width = 0, height = 0;
};

/// Shows the window before there is a scene.
void loading_layout(const std::string& doing);

/// Draws all, and takes the keys. `doing`: what takes long now, or empty.
PictureArea main_layout(Desk& desk, const History& history, const std::string& doing,
                        const std::vector<KeyPress>& keys);

}  // namespace dermis::viewer
