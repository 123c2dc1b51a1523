// SPDX-License-Identifier: MIT
// Saves documents as files.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/settings/fields.h"
#include "viewer/model/saving.h"
#include "viewer/panels/desk.h"
#include "viewer/panels/places.h"
#include "viewer/panels/rows.h"

namespace dermis::viewer {
namespace {

// Rows of the picture's size; the window's own without them.
void size_rows(Desk& desk) {
  ImGui::Checkbox("a size of its own", &desk.view.fixed_size);
  if (!desk.view.fixed_size) {
    ImGui::SameLine();
    ImGui::TextDisabled("(else that of the window)");
    return;
  }
  Document next = desk.now;
  bool changed = false;
  for_each_setting(next.settings.output,
                   [&](const std::string& path, const About& about, auto& value, std::string_view) {
                     if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, int>)
                       if (about.option == "size") changed |= number_row(path, about, value);
                   });
  if (changed) desk.changed("size", std::move(next));
}

void record_rows(Desk& desk) {
  Recording& recording = desk.view.recording;
  ImGui::Separator();
  ImGui::TextUnformatted("Sequence");
  ImGui::BeginDisabled(desk.view.records);
  int motion = static_cast<int>(recording.motion);
  if (ImGui::Combo("moves", &motion, "the camera, once around\0a lamp, once around\0the clip\0"))
    recording.motion = static_cast<RecordedMotion>(motion);
  ImGui::InputDouble("frames per second", &recording.fps, 0, 0, "%g");
  note_place("frames per second");
  if (recording.motion != RecordedMotion::clip) {
    ImGui::InputDouble("seconds", &recording.seconds, 0, 0, "%g");
    note_place("seconds");
  }
  ImGui::Checkbox("a video (.mp4, by ffmpeg), else pictures", &recording.video);
  note_place("a video");
  ImGui::EndDisabled();
  if (desk.view.records)
    desk.requests.stop_recording |= noted_button("Stop recording");
  else
    desk.requests.record |= noted_button("Record");
}

}  // namespace

void save_panel(Desk& desk) {
  Requests& requests = desk.requests;
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.6f);
  ImGui::InputText("name", &desk.view.save_name);
  note_place("name");
  size_rows(desk);

  const ImVec2 wide(ImGui::GetContentRegionAvail().x, 0);
  requests.save_png |= noted_button("Picture, as shown (.png)", wide);
  requests.save_exr |= noted_button("Picture, linear light (.exr)", wide);
  requests.save_settings |= noted_button("Settings (.settings.json)", wide);
  requests.save_scene |= noted_button("Scene (.scene.json)", wide);
  requests.save_profile |= noted_button("Profile (.profile.json)", wide);
  requests.copy_command |= noted_button("Copy the command line", wide);
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("draws exactly this picture; writes the scene file that it needs");
  if (!desk.view.command_line.empty()) {
    ImGui::InputTextMultiline("##command", &desk.view.command_line, {wide.x, ImGui::GetFontSize() * 6},
                              ImGuiInputTextFlags_ReadOnly);
  }
  record_rows(desk);
  ImGui::PopItemWidth();
}

}  // namespace dermis::viewer
