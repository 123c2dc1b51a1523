// SPDX-License-Identifier: MIT
// Lights: a list, a ball to drag them on, what each is; and the surroundings.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/settings/fields.h"
#include "base/settings/names.h"
#include "base/settings/scene_fields.h"
#include "viewer/model/light_places.h"
#include "viewer/panels/desk.h"
#include "viewer/panels/places.h"
#include "viewer/panels/rows.h"
#include "viewer/panels/settings_rows.h"

namespace dermis::viewer {
namespace {

constexpr float degrees_per_radian = static_cast<float>(180 / std::numbers::pi);

// The ball as the head's front sees it: right of the picture is the head's left. Behind it, lights are
// hollow.
struct Ball {
  ImVec2 centre;
  float radius;

  ImVec2 place(const PlacedLight& at) const {
    const float azimuth = static_cast<float>(at.azimuth_deg) / degrees_per_radian;
    const float elevation = static_cast<float>(at.elevation_deg) / degrees_per_radian;
    return {centre.x + radius * std::cos(elevation) * std::sin(azimuth),
            centre.y - radius * std::sin(elevation)};
  }
  static bool is_behind(const PlacedLight& at) {
    return std::cos(static_cast<float>(at.azimuth_deg) / degrees_per_radian) < 0;
  }
  // The place under the pointer, on the half of the ball that the light is on.
  PlacedLight under(ImVec2 pointer, const PlacedLight& now) const {
    float x = (pointer.x - centre.x) / radius, y = (centre.y - pointer.y) / radius;
    const float length = std::sqrt(x * x + y * y);
    if (length > 0.999f) x *= 0.999f / length, y *= 0.999f / length;
    const float z = std::sqrt(1 - x * x - y * y) * (is_behind(now) ? -1.0f : 1.0f);
    PlacedLight at = now;
    at.elevation_deg = std::round(10 * std::asin(y) * degrees_per_radian) / 10;
    at.azimuth_deg = std::round(10 * std::atan2(x, z) * degrees_per_radian) / 10;
    return at;
  }
};

void draw_ball(const Ball& ball) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(ball.centre, ball.radius, IM_COL32(38, 40, 46, 255), 48);
  for (const float part : {0.5f, 0.87f})
    list.AddCircle(ball.centre, ball.radius * part, IM_COL32(60, 64, 72, 255), 48);
  list.AddLine({ball.centre.x - ball.radius, ball.centre.y}, {ball.centre.x + ball.radius, ball.centre.y},
               IM_COL32(60, 64, 72, 255));
  list.AddLine({ball.centre.x, ball.centre.y - ball.radius}, {ball.centre.x, ball.centre.y + ball.radius},
               IM_COL32(60, 64, 72, 255));
  list.AddCircle(ball.centre, ball.radius, IM_COL32(110, 116, 128, 255), 48);
}

ImU32 dot_colour(const Light& light) {
  const std::array<double, 3> tone = tone_of(light);
  return ImGui::ColorConvertFloat4ToU32(
      ImVec4(static_cast<float>(tone[0]), static_cast<float>(tone[1]), static_cast<float>(tone[2]), 1));
}

// Lights as dots; the selected one follows the pointer.
void light_ball(Desk& desk) {
  const float size = std::min(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 13);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Ball ball{{corner.x + size / 2, corner.y + size / 2}, size / 2 - 4};
  ImGui::InvisibleButton("ball", {size, size});
  note_place("ball");
  draw_ball(ball);

  const Scene& scene = desk.now.scene;
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  float nearest = ImGui::GetFontSize() * 1.2f;
  for (const LightId id : scene.lights()) {
    const SceneLight& light = scene.light(id);
    const PlacedLight at = place_of(light.light, in_rig(desk.sphere, scene, light));
    const ImVec2 dot = ball.place(at);
    const float radius = ImGui::GetFontSize() * 0.42f;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (Ball::is_behind(at))
      list.AddCircle(dot, radius, dot_colour(light.light), 16, 2);
    else
      list.AddCircleFilled(dot, radius, dot_colour(light.light), 16);
    if (desk.view.light == id) list.AddCircle(dot, radius + 3, IM_COL32(255, 190, 90, 255), 20, 2);

    const float distance = std::hypot(pointer.x - dot.x, pointer.y - dot.y);
    if (ImGui::IsItemActivated() && distance < nearest) {
      nearest = distance;
      desk.view.light = id;
    }
  }

  const ImVec2 drag = ImGui::GetIO().MouseDelta;
  if (!ImGui::IsItemActive() || !desk.view.light || (drag.x == 0 && drag.y == 0)) return;
  SceneLight light = scene.light(*desk.view.light);
  const HeadSphere sphere = in_rig(desk.sphere, scene, light);
  light.light = placed(light.light, ball.under(pointer, place_of(light.light, sphere)), sphere);
  desk.edit("move light", [&](Document& next) { next.scene.set_light(*desk.view.light, light); });
}

// Where it stands and how strong it is, by the rows of PlacedLight; the rest by those of Light.
bool light_rows(Light& light, const HeadSphere& sphere) {
  const Row row;
  bool changed = false;
  PlacedLight at = place_of(light, sphere);
  bool moved = false;
  for_each_setting(at, [&](const std::string& path, const About& about, auto& value, std::string_view) {
    moved |= row(path, about, value);
  });
  if (moved) {
    light = placed(light, at, sphere);
    changed = true;
  }

  std::array<double, 3> tone = tone_of(light);
  float colour[3] = {static_cast<float>(tone[0]), static_cast<float>(tone[1]), static_cast<float>(tone[2])};
  const auto other = [&](const std::string& path, const About& about, auto& value, std::string_view) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::array<double, 3>>) {
      // Position and direction follow from azimuth and elevation.
      if (path != "colour") return;
      if (ImGui::ColorEdit3(label_of(path).c_str(), colour, ImGuiColorEditFlags_Float)) {
        light = with_tone(light, {colour[0], colour[1], colour[2]});
        changed = true;
      }
      show_help(about);
    } else {
      changed |= row(path, about, value);
    }
  };
  for_each_setting(light, other);
  return changed;
}

void selected_light(Desk& desk) {
  const Scene& scene = desk.now.scene;
  SceneLight light = scene.light(*desk.view.light);
  const HeadSphere sphere = in_rig(desk.sphere, scene, light);
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.5f);
  if (light_rows(light.light, sphere))
    desk.edit("light", [&](Document& next) { next.scene.set_light(*desk.view.light, light); });
  ImGui::PopItemWidth();
}

void light_list(Desk& desk) {
  const Scene& scene = desk.now.scene;
  int number = 0;
  for (const LightId id : scene.lights()) {
    const std::string& name = scene.light(id).light.name;
    const std::string label = (name.empty() ? "light " + std::to_string(number + 1) : name) + "##" +
                              std::to_string(static_cast<std::uint32_t>(id));
    ++number;
    if (ImGui::Selectable(label.c_str(), desk.view.light == id)) desk.view.light = id;
    note_place("light " + std::to_string(number));
  }
}

void buttons(Desk& desk) {
  if (noted_button("Add a lamp"))
    desk.edit("add a lamp", [&](Document& next) {
      desk.view.light = add_lamp(next, PlacedLight{.azimuth_deg = 30, .elevation_deg = 20});
    });
  if (!desk.view.light) return;
  ImGui::SameLine();
  if (!noted_button("Remove")) return;
  desk.edit("remove a light", [&](Document& next) {
    next.scene.remove_light(*desk.view.light);
    // A scene without any would have the rig.
    if (next.scene.lights().empty()) next.settings.lighting.rig_lights = 0;
  });
  desk.view.light.reset();
}

}  // namespace

void light_panel(Desk& desk) {
  const std::vector<LightId> lights = desk.now.scene.lights();
  if (std::find(lights.begin(), lights.end(), desk.view.light) == lights.end()) desk.view.light.reset();

  if (!draws_scene_lights(desk.now) && desk.now.settings.lighting.rig_lights != 0) {
    ImGui::TextWrapped("The settings place the lights.");
    if (noted_button("Edit each of them")) desk.edit("own lights", own_lights);
  } else {
    light_ball(desk);
    light_list(desk);
    buttons(desk);
    if (desk.view.light && !desk.next) {
      ImGui::Separator();
      selected_light(desk);
    }
  }

  ImGui::Separator();
  settings_rows(desk, "lighting");
}

}  // namespace dermis::viewer
