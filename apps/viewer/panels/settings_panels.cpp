// SPDX-License-Identifier: MIT
// Technique, quality, camera and picture: every setting that has a row.
#include <imgui.h>

#include "base/settings/fields.h"
#include "base/settings/names.h"
#include "dermis/error.h"
#include "render/setup/frame_setup.h"
#include "viewer/panels/desk.h"
#include "viewer/panels/rows.h"
#include "viewer/panels/settings_rows.h"

namespace dermis::viewer {
namespace {

std::vector<std::string> choices_of(const Desk& desk, const std::string& path) {
  if (path == "technique") return technique_names();
  if (path == "camera.name") {
    std::vector<std::string> names = camera_names(desk.now.scene);
    names.insert(names.begin(), "");
    return names;
  }
  if (path == "lighting.environment") return {"", "studio"};
  if (path == "output.background") return {"black", "studio", "environment", "#808080"};
  return {};
}

// Whether the settings with this number would be accepted.
bool accepts(const Desk& desk, const std::string& wanted, int value) {
  RenderSettings tried = desk.now.settings;
  for_each_setting(tried, [&](const std::string& path, const About&, auto& member, std::string_view) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, int>)
      if (path == wanted) member = value;
  });
  try {
    setup::check_settings(tried);
    return true;
  } catch (const InputError&) { return false; }
}

}  // namespace

void settings_rows(Desk& desk, std::string_view section) {
  Document next = desk.next.value_or(desk.now);
  const Row row{.choices = [&](const std::string& path) { return choices_of(desk, path); },
                .accepts = [&](const std::string& path, int value) { return accepts(desk, path, value); }};
  std::string changed;
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.5f);
  for_each_setting(next.settings,
                   [&](const std::string& path, const About& about, auto& value, std::string_view) {
                     const bool is_here = path.starts_with(std::string(section) + ".") || path == section;
                     // The size is of the save panel; frames are of the command line.
                     const bool is_elsewhere = about.option == "size" || about.option == "frames" ||
                                               about.option == "show" || about.option == "lights";
                     if (!is_here || is_elsewhere) return;
                     if (row(path, about, value)) changed = label_of(path);
                   });
  ImGui::PopItemWidth();
  if (changed.empty()) return;

  // A camera is placed in one way: whichever was chosen last.
  CameraSettings& camera = next.settings.camera;
  if (!camera.name.empty() && camera.name != desk.now.settings.camera.name) {
    camera.eye_m.reset();
    camera.target_m.reset();
  }
  if (camera.eye_m.has_value() != camera.target_m.has_value()) {
    if (desk.now.settings.camera.eye_m) {
      camera.eye_m.reset();
      camera.target_m.reset();
    } else {
      // One of the two was given by hand: the other one is where it is now.
      const std::optional<std::array<double, 3>> eye = camera.eye_m, target = camera.target_m;
      set_camera(next.settings, camera_place(desk.now));
      if (eye) camera.eye_m = eye;
      if (target) camera.target_m = target;
    }
  }
  if (camera.eye_m && (camera.distance || camera.orbit_deg != CameraSettings{}.orbit_deg)) {
    camera.eye_m.reset();
    camera.target_m.reset();
  }
  desk.changed(changed, std::move(next));
}

void picture_panel(Desk& desk) {
  settings_rows(desk, "technique");
  // The other sections have panels of their own.
  const auto one = [&](const auto& field) {
    const std::string name(field.name), title(field.about.help);
    if (name != "output" && name != "camera" && name != "quality") return;
    if (!ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) return;
    ImGui::PushID(name.c_str());
    settings_rows(desk, name);
    ImGui::PopID();
  };
  std::apply([&](const auto&... field) { (one(field), ...); }, fields_of<RenderSettings>);
}

}  // namespace dermis::viewer
