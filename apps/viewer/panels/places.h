// SPDX-License-Identifier: MIT
/// Where widgets are in the window, by name: for scripts that click on them (dermis view --tell).
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

namespace dermis::viewer {

struct Place {
  std::string name;
  int x = 0, y = 0, width = 0, height = 0;  ///< of the part that is seen
  bool operator==(const Place&) const = default;
};

/// Of one frame; the window has one thread.
std::vector<Place>& places();

/// Notes where the last widget is, if any of it is seen.
void note_place(const std::string& name);

/// A button that is noted.
bool noted_button(const std::string& label, ImVec2 size = {0, 0});
/// A header that opens and closes, noted.
bool noted_header(const std::string& label, ImGuiTreeNodeFlags flags = 0);

}  // namespace dermis::viewer
