// SPDX-License-Identifier: MIT
// A and B in one view: B is what was kept, or the truth.
#include <fmt/format.h>
#include <imgui.h>

#include "viewer/panels/desk.h"
#include "viewer/panels/places.h"

namespace dermis::viewer {
namespace {

void mode_row(CompareState& compare) {
  for (std::size_t i = 0; i < std::size(compare_mode_titles); ++i) {
    if (i > 0 && i != 3) ImGui::SameLine();
    if (ImGui::RadioButton(compare_mode_titles[i], compare.mode == static_cast<CompareMode>(i)))
      compare.mode = static_cast<CompareMode>(i);
    note_place(compare_mode_titles[i]);
  }
}

void figures(const Desk& desk) {
  const Comparison& comparison = *desk.comparison;
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV;
  if (!ImGui::BeginTable("regions", 4, flags)) return;
  for (const char* title : {"where", "FLIP", "PSNR, dB", "rel. MSE"}) ImGui::TableSetupColumn(title);
  ImGui::TableHeadersRow();
  for (const RegionFigures& region : comparison.regions) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(region.name.c_str());
    ImGui::TableNextColumn();
    ImGui::Text("%.4f", region.flip);
    ImGui::TableNextColumn();
    ImGui::Text("%.1f", region.psnr_db);
    ImGui::TableNextColumn();
    ImGui::Text("%.2e", region.rel_mse);
  }
  ImGui::EndTable();
}

}  // namespace

void compare_panel(Desk& desk) {
  CompareState& compare = desk.view.compare;
  ImGui::TextDisabled("A is what is edited. B:");
  if (noted_button("Keep this as B")) {
    compare.kept = desk.now;
    ++compare.kept_serial;
    compare.truth = false;
    if (compare.mode == CompareMode::off) compare.mode = CompareMode::slider;
  }
  ImGui::SameLine();
  if (noted_button("Ground truth as B")) {
    compare.truth = true;
    if (compare.mode == CompareMode::off) compare.mode = CompareMode::slider;
  }
  if (compare.kept && !compare.truth) {
    ImGui::SameLine();
    if (noted_button("Swap")) {
      Document a = *compare.kept;
      a.settings.camera = desk.now.settings.camera;
      compare.kept = desk.now;
      ++compare.kept_serial;
      desk.changed("swap A and B", std::move(a));
    }
  }
  if (!compare.truth && !compare.kept) {
    ImGui::TextWrapped("Keep a state as B, change something, and look at both under a slider.");
    return;
  }

  mode_row(compare);
  if (compare.truth) {
    ImGui::TextWrapped("%s", desk.truth_text.c_str());
    ImGui::TextDisabled("both without bloom, at 1/%d of the size", desk.truth_divisor);
  }
  if (desk.comparison) figures(desk);
  if (!desk.comparison && compare.mode != CompareMode::off) ImGui::TextDisabled("B comes when A rests");
}

}  // namespace dermis::viewer
