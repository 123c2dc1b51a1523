// SPDX-License-Identifier: MIT
#include "viewer/panels/places.h"

namespace dermis::viewer {

std::vector<Place>& places() {
  static std::vector<Place> all;
  return all;
}

void note_place(const std::string& name) {
  if (!ImGui::IsItemVisible()) return;
  const ImVec2 low = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
  places().push_back({name, static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(size.x),
                      static_cast<int>(size.y)});
}

bool noted_button(const std::string& label, ImVec2 size) {
  const bool pressed = ImGui::Button(label.c_str(), size);
  note_place(label);
  return pressed;
}

bool noted_header(const std::string& label, ImGuiTreeNodeFlags flags) {
  const bool open = ImGui::CollapsingHeader(label.c_str(), flags);
  note_place(label);
  return open;
}

}  // namespace dermis::viewer
