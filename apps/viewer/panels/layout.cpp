// SPDX-License-Identifier: MIT
#include "viewer/panels/layout.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "viewer/panels/places.h"

namespace dermis::viewer {
namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

void take_keys(Desk& desk, const std::vector<KeyPress>& keys) {
  if (ImGui::GetIO().WantTextInput) return;
  Requests& requests = desk.requests;
  for (const KeyPress& key : keys) {
    if (key.ctrl && key.letter == 'Z') (key.shift ? requests.redo : requests.undo) = true;
    if (key.ctrl && key.letter == 'Y') requests.redo = true;
    if (key.ctrl && key.letter == 'S') requests.save_png = true;
    if (key.ctrl) continue;
    if (key.letter == 'F') requests.frame = true;
    if (key.letter == 'P') desk.view.panels = !desk.view.panels;
  }
}

void undo_buttons(Desk& desk, const History& history) {
  const auto one = [](const char* label, bool can, const std::string& what, bool& wanted) {
    ImGui::BeginDisabled(!can);
    if (ImGui::SmallButton(label)) wanted = true;
    note_place(label);
    ImGui::EndDisabled();
    if (can && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", what.c_str());
    ImGui::SameLine();
  };
  one("Undo", history.can_undo(), history.can_undo() ? history.undo_name() : "", desk.requests.undo);
  one("Redo", history.can_redo(), history.can_redo() ? history.redo_name() : "", desk.requests.redo);
  if (ImGui::SmallButton("Frame")) desk.requests.frame = true;
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("looks at the heads (F)");
}

struct Tab {
  const char* title;
  void (*draw)(Desk&);
};
constexpr std::array tabs{Tab{"Picture", picture_panel}, Tab{"Light", light_panel},
                          Tab{"Skin", skin_panel},       Tab{"Pose", animation_panel},
                          Tab{"Compare", compare_panel}, Tab{"Inside", inside_panel},
                          Tab{"Save", save_panel}};

void panels(Desk& desk, const History& history, ImVec2 low, ImVec2 size) {
  ImGui::SetNextWindowPos(low);
  ImGui::SetNextWindowSize(size);
  ImGui::Begin("panels", nullptr, fixed);
  undo_buttons(desk, history);
  // A tab takes no press in a frame before which the pointer was on another widget. On a slow device move and
  // press often come within one frame.
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) ImGui::GetCurrentContext()->HoveredIdPreviousFrame = 0;
  if (ImGui::BeginTabBar("tabs")) {
    for (const Tab& tab : tabs) {
      const bool open = ImGui::BeginTabItem(tab.title);
      note_place(tab.title);
      if (!open) continue;
      ImGui::BeginChild("contents");
      tab.draw(desk);
      ImGui::EndChild();
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  ImGui::End();
}

// At the right of the line, as much of it as there is room for.
void cost_of_picture(const Painted& shown, float left, float right) {
  const std::string cost =
      fmt::format("{}x{}  {:.0f} ms", shown.picture.width, shown.picture.height, shown.ms);
  for (const std::string& words : {cost + "  " + shown.picture.statistics.device, cost}) {
    const float x = right - ImGui::CalcTextSize(words.c_str()).x - 10;
    if (x < left + ImGui::GetFontSize()) continue;
    ImGui::SameLine(x - ImGui::GetWindowPos().x);
    ImGui::TextDisabled("%s", words.c_str());
    return;
  }
}

// One line: what is wrong or was done, what takes long, what the picture cost.
void status_line(const Desk& desk, const std::string& doing, ImVec2 low, ImVec2 size) {
  ImGui::SetNextWindowPos(low);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(8, 3));
  ImGui::Begin("status", nullptr, fixed);
  if (!doing.empty()) {
    ImGui::TextUnformatted(doing.c_str());
  } else if (!desk.view.message.empty()) {
    const ImVec4 colour = desk.view.is_error ? ImVec4(1, 0.5f, 0.4f, 1) : ImVec4(0.8f, 0.8f, 0.8f, 1);
    ImGui::TextColored(colour, "%s", desk.view.message.c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", desk.view.message.c_str());
  } else {
    ImGui::TextDisabled(
        "drag: orbit   right drag: pan   wheel: nearer   WASD QE: fly   F: frame   P: panels");
  }
  if (desk.shown) cost_of_picture(*desk.shown, ImGui::GetItemRectMax().x, low.x + size.x);
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace

void loading_layout(const std::string& doing) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::Begin("loading", nullptr, fixed);
  ImGui::TextUnformatted(doing.empty() ? "loading" : doing.c_str());
  ImGui::End();
}

PictureArea main_layout(Desk& desk, const History& history, const std::string& doing,
                        const std::vector<KeyPress>& keys) {
  places().clear();
  take_keys(desk, keys);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float line = ImGui::GetFrameHeight() + 2;
  const float side = desk.view.panels ? std::min(ImGui::GetFontSize() * 27, window.x * 0.5f) : 0;
  const ImVec2 picture(window.x - side, window.y - line);

  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(picture);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin("picture", nullptr, fixed | ImGuiWindowFlags_NoScrollWithMouse);
  picture_view(desk, desk.shown);
  ImGui::End();
  ImGui::PopStyleVar();

  if (side > 0) panels(desk, history, {picture.x, 0}, {side, picture.y});
  status_line(desk, doing, {0, picture.y}, {window.x, line});

  const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
  return {static_cast<int>(std::lround(picture.x * pixels.x)),
          static_cast<int>(std::lround(picture.y * pixels.y))};
}

}  // namespace dermis::viewer
