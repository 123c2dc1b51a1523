// SPDX-License-Identifier: MIT
#include "viewer/window/style.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <filesystem>

namespace dermis::viewer {
namespace {

// A font of the system is easier to read than the one of pixels that ImGui brings.
constexpr std::array fonts{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                           "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                           "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"};

void set_font(double scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  std::error_code ignored;
  for (const char* font : fonts)
    if (std::filesystem::exists(font, ignored) &&
        atlas.AddFontFromFileTTF(font, static_cast<float>(std::round(14 * scale))))
      return;
  ImFontConfig config;
  config.SizePixels = static_cast<float>(std::round(13 * scale));
  atlas.AddFontDefault(&config);
}

}  // namespace

void set_style(double scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.FrameRounding = style.GrabRounding = style.TabRounding = 3;
  style.WindowBorderSize = 0;
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.13f, 0.13f, 0.14f, 1);
  style.Colors[ImGuiCol_FrameBg] = ImVec4(0.22f, 0.22f, 0.24f, 1);
  const ImVec4 accent(0.62f, 0.36f, 0.29f, 1), strong(0.75f, 0.45f, 0.36f, 1), faint(0.35f, 0.24f, 0.21f, 1);
  for (const ImGuiCol colour : {ImGuiCol_Header, ImGuiCol_Button, ImGuiCol_Tab, ImGuiCol_FrameBgHovered})
    style.Colors[colour] = faint;
  for (const ImGuiCol colour : {ImGuiCol_HeaderHovered, ImGuiCol_ButtonHovered, ImGuiCol_TabHovered,
                                ImGuiCol_TabActive, ImGuiCol_SliderGrab, ImGuiCol_FrameBgActive})
    style.Colors[colour] = accent;
  for (const ImGuiCol colour :
       {ImGuiCol_HeaderActive, ImGuiCol_ButtonActive, ImGuiCol_CheckMark, ImGuiCol_SliderGrabActive})
    style.Colors[colour] = strong;
  style.ScaleAllSizes(static_cast<float>(scale));
  set_font(scale);
}

}  // namespace dermis::viewer
