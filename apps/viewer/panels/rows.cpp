// SPDX-License-Identifier: MIT
#include "viewer/panels/rows.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <map>

#include "base/settings/check.h"
#include "cli/settings_options.h"
#include "viewer/panels/places.h"

namespace dermis::viewer {
namespace {

// Where nearly all useful numbers lie far below the end of the range, a drag goes by the number itself.
float drag_speed(const About& about, double value) {
  const double span = about.most - about.least;
  if (std::isfinite(span) && span <= 400) return static_cast<float>(span / 400);
  return static_cast<float>(std::max(std::abs(value), 0.05) / 100);
}

std::string format_of(const About& about, const char* number) {
  std::string unit(about.unit);
  for (std::size_t at = 0; (at = unit.find('%', at)) != std::string::npos; at += 2) unit.insert(at, "%");
  return std::string(number) + (unit.empty() ? "" : " " + unit);
}

bool is_slider(const About& about) { return std::isfinite(about.most) && about.most - about.least <= 10; }

}  // namespace

std::string label_of(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  std::string label(dot == std::string_view::npos ? path : path.substr(dot + 1));
  std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

void show_help(const About& about) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28);
  std::string text = cli::help_of(about);
  if (const std::string range = range_text(about); !range.empty()) text += "\n" + range;
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool number_row(const std::string& label, const About& about, double& value) {
  const std::string format = format_of(about, "%.4g");
  double least = std::isfinite(about.least) ? about.least : -DBL_MAX / 2;
  double most = std::isfinite(about.most) ? about.most : DBL_MAX / 2;
  if (about.open) {
    const double inside = (most - least) * 1e-4;
    least += inside;
    most -= inside;
  }
  constexpr ImGuiSliderFlags clamp = ImGuiSliderFlags_AlwaysClamp;
  double edited = value;
  const bool changed =
      is_slider(about) ? ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, &edited, &least, &most,
                                             format.c_str(), clamp)
                       : ImGui::DragScalar(label.c_str(), ImGuiDataType_Double, &edited,
                                           drag_speed(about, value), &least, &most, format.c_str(), clamp);
  note_place(label);
  show_help(about);
  // Six digits are more than a hand can tell apart, and make short command lines.
  if (changed && edited != 0) {
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(edited))) - 5);
    edited = std::clamp(std::round(edited / digit) * digit, least, most);
  }
  if (!changed || !std::isfinite(edited) || edited == value) return false;
  value = edited;
  return true;
}

bool number_row(const std::string& label, const About& about, int& value) {
  const int least = std::isfinite(about.least) ? static_cast<int>(about.least) : INT32_MIN / 2;
  const int most = std::isfinite(about.most) ? static_cast<int>(std::min(about.most, 1e9)) : INT32_MAX / 2;
  const float speed = std::max(0.05f, static_cast<float>(std::abs(value)) / 200);
  const int before = value;
  ImGui::DragInt(label.c_str(), &value, speed, least, most, format_of(about, "%d").c_str(),
                 ImGuiSliderFlags_AlwaysClamp);
  note_place(label);
  show_help(about);
  return value != before;
}

bool number_row(const std::string& label, const About& about, std::uint64_t& value) {
  const std::uint64_t least = std::isfinite(about.least) ? static_cast<std::uint64_t>(about.least) : 0;
  const std::uint64_t most =
      std::isfinite(about.most) ? static_cast<std::uint64_t>(about.most) : UINT64_MAX / 2;
  const std::uint64_t before = value;
  ImGui::DragScalar(label.c_str(), ImGuiDataType_U64, &value,
                    std::max(0.05f, static_cast<float>(value) / 200), &least, &most, "%llu",
                    ImGuiSliderFlags_AlwaysClamp);
  note_place(label);
  show_help(about);
  value = std::clamp(value, least, most);
  return value != before;
}

bool switch_row(const std::string& label, const About& about, bool& value) {
  const bool changed = ImGui::Checkbox(label.c_str(), &value);
  note_place(label);
  show_help(about);
  return changed;
}

bool text_row(const std::string& label, const About& about, std::string& value,
              const std::vector<std::string>& choices) {
  // Text that is being typed, until it is finished.
  static std::map<ImGuiID, std::string> typed;
  ImGui::PushID(label.c_str());
  const ImGuiID id = ImGui::GetID("text");
  const auto found = typed.find(id);
  std::string text = found == typed.end() ? value : found->second;
  const std::string hint(about.none);

  const float button = choices.empty() ? 0 : ImGui::GetFrameHeight();
  ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - button);
  const bool edited = ImGui::InputTextWithHint("##text", hint.c_str(), &text);
  if (ImGui::IsItemActive() && (edited || found != typed.end())) typed[id] = text;
  bool changed = false;
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    changed = text != value;
    value = text;
  }
  if (!ImGui::IsItemActive()) typed.erase(id);
  note_place(label);
  show_help(about);

  if (!choices.empty()) {
    ImGui::SameLine(0, 0);
    if (ImGui::BeginCombo("##choices", "", ImGuiComboFlags_NoPreview)) {
      for (const std::string& choice : choices)
        if (ImGui::Selectable(choice.empty() ? "(none)" : choice.c_str(), choice == value) &&
            choice != value) {
          value = choice;
          changed = true;
        }
      ImGui::EndCombo();
    }
  }
  ImGui::SameLine();
  ImGui::TextUnformatted(label.c_str());
  show_help(about);
  ImGui::PopID();
  return changed;
}

bool choice_row(const std::string& label, const About& about, const std::vector<std::string_view>& names,
                std::size_t& value) {
  bool changed = false;
  const std::string now(value < names.size() ? names[value] : std::string_view{});
  const bool open = ImGui::BeginCombo(label.c_str(), now.c_str());
  if (!open) note_place(label), show_help(about);
  if (!open) return false;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (ImGui::Selectable(std::string(names[i]).c_str(), i == value) && i != value) {
      value = i;
      changed = true;
    }
  ImGui::EndCombo();
  return changed;
}

bool few_row(const std::string& label, const About& about, int& value,
             const std::function<bool(int)>& accepts) {
  bool changed = false;
  const bool open = ImGui::BeginCombo(label.c_str(), std::to_string(value).c_str());
  if (!open) note_place(label), show_help(about);
  if (!open) return false;
  for (int tried = static_cast<int>(about.least); tried <= static_cast<int>(about.most); ++tried)
    if (accepts(tried) && ImGui::Selectable(std::to_string(tried).c_str(), tried == value) &&
        tried != value) {
      value = tried;
      changed = true;
    }
  ImGui::EndCombo();
  return changed;
}

bool given_row(const std::string& label, bool& given) {
  const bool changed = ImGui::Checkbox(("##given " + label).c_str(), &given);
  note_place("given " + label);
  return changed;
}

}  // namespace dermis::viewer
