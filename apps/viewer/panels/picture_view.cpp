// SPDX-License-Identifier: MIT
// The picture, and the mouse and keys in it.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viewer/model/light_places.h"
#include "viewer/panels/desk.h"
#include "viewer/panels/places.h"
#include "viewer/window/ui_renderer.h"

namespace dermis::viewer {
namespace {

constexpr double degrees_per_pixel = 0.4;
constexpr double dolly_per_notch = 0.9;

// Where the picture lies in the region: all of it, or as large as it fits.
struct Frame {
  ImVec2 low, size;
};

Frame frame_of(const Desk& desk, ImVec2 low, ImVec2 region) {
  if (!desk.view.fixed_size) return {low, region};
  const OutputSettings& output = desk.now.settings.output;
  const float aspect = static_cast<float>(output.width) / static_cast<float>(output.height);
  const ImVec2 size = region.x / region.y > aspect ? ImVec2(region.y * aspect, region.y)
                                                   : ImVec2(region.x, region.x / aspect);
  return {{low.x + (region.x - size.x) / 2, low.y + (region.y - size.y) / 2}, size};
}

void move(Desk& desk, const char* what, const CameraPlace& place) {
  desk.edit(what, [&](Document& next) { set_camera(next.settings, place); });
}

// A lamp that is selected follows the pointer while Shift is held.
bool drag_light(Desk& desk, ImVec2 drag) {
  if (!ImGui::GetIO().KeyShift || !desk.view.light || !draws_scene_lights(desk.now)) return false;
  desk.edit("move light", [&](Document& next) {
    SceneLight light = next.scene.light(*desk.view.light);
    const HeadSphere sphere = in_rig(desk.sphere, next.scene, light);
    PlacedLight at = place_of(light.light, sphere);
    at.azimuth_deg += drag.x * degrees_per_pixel;
    at.elevation_deg = std::clamp(at.elevation_deg - drag.y * degrees_per_pixel, -89.0, 89.0);
    light.light = placed(light.light, at, sphere);
    next.scene.set_light(*desk.view.light, light);
  });
  return true;
}

// The surroundings turn while Ctrl is held.
bool turn_surroundings(Desk& desk, ImVec2 drag) {
  if (!ImGui::GetIO().KeyCtrl) return false;
  desk.edit("turn surroundings", [&](Document& next) {
    double& rotation = next.settings.lighting.environment_rotation_deg;
    rotation = std::remainder(std::round((rotation + drag.x * degrees_per_pixel) * 10) / 10, 360.0);
  });
  return true;
}

void drag(Desk& desk, const Frame& frame) {
  const ImVec2 by = ImGui::GetIO().MouseDelta;
  if (by.x == 0 && by.y == 0) return;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    if (drag_light(desk, by) || turn_surroundings(desk, by)) return;
    move(desk, "orbit", orbited(camera_place(desk.now), -by.x * degrees_per_pixel, by.y * degrees_per_pixel));
  } else {
    move(desk, "pan", panned(camera_place(desk.now), -by.x / frame.size.y, by.y / frame.size.y));
  }
}

bool is_down(char key) {
#if IMGUI_VERSION_NUM >= 18700
  return ImGui::IsKeyDown(static_cast<ImGuiKey>(ImGuiKey_A + (key - 'A')));
#else
  return ImGui::IsKeyDown(key);  // GLFW numbers letters as ASCII does
#endif
}

// W, A, S, D, Q, E: half the distance to the target per second.
void fly(Desk& desk) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput || io.KeyCtrl) return;
  const double right = is_down('D') - is_down('A'), up = is_down('E') - is_down('Q'),
               ahead = is_down('W') - is_down('S');
  if (right == 0 && up == 0 && ahead == 0) return;
  const CameraPlace place = camera_place(desk.now);
  const double distance = std::hypot(place.eye_m[0] - place.target_m[0], place.eye_m[1] - place.target_m[1],
                                     place.eye_m[2] - place.target_m[2]);
  const double step = distance / 2 * std::min(static_cast<double>(io.DeltaTime), 0.1);
  move(desk, "fly", flown(place, {right * step, up * step, ahead * step}));
}

// The line between A and B, if the pointer has taken it. Of the last item.
bool slide(Desk& desk, const Frame& frame) {
  CompareState& compare = desk.view.compare;
  const float x = ImGui::GetIO().MousePos.x, line = frame.low.x + frame.size.x * compare.at;
  if (ImGui::IsItemActivated())
    compare.slides = compare.is_on() && compare.mode == CompareMode::slider && desk.shown_b &&
                     std::abs(x - line) < ImGui::GetFontSize() * 0.6f;
  if (!compare.slides || !ImGui::IsItemActive()) return false;
  compare.at = std::clamp((x - frame.low.x) / frame.size.x, 0.0f, 1.0f);
  return true;
}

// Throws InputError: the settings name no camera of the scene.
void move_camera(Desk& desk, const Frame& frame) {
  if (!slide(desk, frame) && ImGui::IsItemActive()) drag(desk, frame);
  desk.view.pointer.reset();
  if (!ImGui::IsItemHovered()) return;
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  desk.view.pointer = {(pointer.x - frame.low.x) / frame.size.x, (pointer.y - frame.low.y) / frame.size.y};
  if (const float wheel = ImGui::GetIO().MouseWheel; wheel != 0)
    move(desk, "dolly", dollied(camera_place(desk.now), std::pow(dolly_per_notch, wheel)));
  fly(desk);
}

void corner_text(ImVec2 at, const std::string& text) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - 4, at.y - 2}, {at.x + size.x + 4, at.y + size.y + 2}, IM_COL32(0, 0, 0, 150), 3);
  list.AddText(at, IM_COL32(230, 230, 230, 255), text.c_str());
}

// A at the left of a line that can be dragged, B at its right.
void draw_slider(Desk& desk, const Frame& frame, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float& at = desk.view.compare.at;
  const float x = frame.low.x + frame.size.x * at, grip = ImGui::GetFontSize() * 0.5f;
  list.AddImage(texture_id(PictureSlot::a), frame.low, {x, high.y}, {0, 0}, {at, 1});
  list.AddImage(texture_id(PictureSlot::b), {x, frame.low.y}, high, {at, 0}, {1, 1});
  list.AddLine({x, frame.low.y}, {x, high.y}, IM_COL32(255, 255, 255, 200), 2);
  list.AddCircleFilled({x, (frame.low.y + high.y) / 2}, grip, IM_COL32(255, 255, 255, 230), 20);

  corner_text({frame.low.x + 10, high.y - 26}, "A");
  corner_text({high.x - 22, high.y - 26}, "B");
}

// Draws the comparison; false: A alone.
bool draw_compared(Desk& desk, const Frame& frame, ImVec2 high) {
  const CompareState& compare = desk.view.compare;
  if (!compare.is_on() || !desk.shown_b) return false;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (compare.mode == CompareMode::slider) {
    draw_slider(desk, frame, high);
    return true;
  }
  if (compare.mode == CompareMode::blink) {
    const bool is_b = std::fmod(ImGui::GetTime(), 2 * blink_s) > blink_s;
    list.AddImage(texture_id(is_b ? PictureSlot::b : PictureSlot::a), frame.low, high);
    corner_text({frame.low.x + 10, high.y - 26}, is_b ? "B" : "A");
    return true;
  }
  if (!desk.comparison || desk.comparison->map_rgba.empty()) return false;
  list.AddImage(texture_id(PictureSlot::map), frame.low, high);
  return true;
}

// A bar as long as so many millimetres where the camera looks at.
void draw_scale(const Desk& desk, const Frame& frame, ImVec2 high) {
  const CameraPlace place = camera_place(desk.now);
  const double distance_m = std::hypot(place.eye_m[0] - place.target_m[0], place.eye_m[1] - place.target_m[1],
                                       place.eye_m[2] - place.target_m[2]);
  const double mm_per_pixel =
      2000 * distance_m * std::tan(place.fov_deg * std::numbers::pi / 360) / frame.size.y;
  double length_mm = std::pow(10, std::floor(std::log10(mm_per_pixel * frame.size.x / 4)));
  for (const double factor : {5.0, 2.0})
    if (length_mm * factor / mm_per_pixel < frame.size.x / 4) {
      length_mm *= factor;
      break;
    }

  const float pixels = static_cast<float>(length_mm / mm_per_pixel);
  const ImVec2 right(high.x - 16, high.y - 40), left(right.x - pixels, right.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({left.x, left.y + 1}, {right.x, right.y + 1}, IM_COL32(0, 0, 0, 160), 4);
  list.AddLine(left, right, IM_COL32(235, 235, 235, 255), 2);
  corner_text({left.x + 4, left.y - ImGui::GetFontSize() - 6}, fmt::format("{:g} mm", length_mm));
}

// Draws messages of the compiler over the picture of before.
void draw_shader_errors(const std::string& errors, const Frame& frame) {
  const float margin = ImGui::GetFontSize(), width = frame.size.x - 2 * margin;
  if (width < margin) return;
  const ImVec2 size = ImGui::CalcTextSize(errors.c_str(), nullptr, false, width);
  const ImVec2 low(frame.low.x + margin, frame.low.y + 2 * margin);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({low.x - 6, low.y - 4}, {low.x + size.x + 6, low.y + size.y + 4},
                     IM_COL32(60, 0, 0, 215), 3);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), low, IM_COL32(255, 190, 180, 255), errors.c_str(),
               nullptr, width);
}

void draw_picture(Desk& desk, const Painted* shown, const Frame& frame) {
  const ImVec2 high(frame.low.x + frame.size.x, frame.low.y + frame.size.y);
  if (!draw_compared(desk, frame, high))
    ImGui::GetWindowDrawList()->AddImage(texture_id(PictureSlot::a), frame.low, high);
  if (desk.view.scale) draw_scale(desk, frame, high);
  if (shown->divisor > 1)
    corner_text({frame.low.x + 10, frame.low.y + 8},
                "1/" + std::to_string(shown->divisor) + " of the size until it rests");
  if (!desk.view.shader_errors.empty()) draw_shader_errors(desk.view.shader_errors, frame);
}

}  // namespace

void picture_view(Desk& desk, const Painted* shown) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), region = ImGui::GetContentRegionAvail();
  if (region.x < 1 || region.y < 1) return;
  const Frame frame = frame_of(desk, low, region);

  ImGui::InvisibleButton("picture", region,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  note_place("picture");
  try {
    move_camera(desk, frame);
    if (shown) draw_picture(desk, shown, frame);
  } catch (const InputError& error) {
    desk.view.message = error.what();
    desk.view.is_error = true;
  }
}

}  // namespace dermis::viewer
