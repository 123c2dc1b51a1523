// SPDX-License-Identifier: MIT
/// Widgets from rows of settings (base/core/fields.h): names, ranges, units and help are the rows' own.
#pragma once

#include <imgui.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/core/fields.h"
#include "base/core/names.h"
#include "dermis/settings.h"

namespace dermis::viewer {

/// "map_size" of "quality.map_size", as "map size".
std::string label_of(std::string_view path);

/// Shows help, unit and range of the row while the pointer rests on the last widget.
void show_help(const About& about);

// Each draws one setting and returns whether it has changed `value`.
bool number_row(const std::string& label, const About& about, double& value);
bool number_row(const std::string& label, const About& about, int& value);
bool number_row(const std::string& label, const About& about, std::uint64_t& value);
bool switch_row(const std::string& label, const About& about, bool& value);
/// Typed text counts when it is finished. `choices`: offered beside it.
bool text_row(const std::string& label, const About& about, std::string& value,
              const std::vector<std::string>& choices = {});
bool choice_row(const std::string& label, const About& about, const std::vector<std::string_view>& names,
                std::size_t& value);
template <std::size_t Count>
bool numbers_row(const std::string& label, const About& about, std::array<double, Count>& values) {
  ImGui::PushID(label.c_str());
  const bool changed = ImGui::DragScalarN("##numbers", ImGuiDataType_Double, values.data(), Count, 0.005f,
                                          nullptr, nullptr, "%.4g");
  ImGui::SameLine();
  ImGui::TextUnformatted(label.c_str());
  show_help(about);
  ImGui::PopID();
  return changed;
}

/// A whole number of few values: only those that `accepts`.
bool few_row(const std::string& label, const About& about, int& value,
             const std::function<bool(int)>& accepts);

/// Whether an optional has a value: a tick before it. Returns whether that has changed.
bool given_row(const std::string& label, bool& given);

/// Any setting.
struct Row {
  /// Texts offered for the setting of a path; may be empty.
  std::function<std::vector<std::string>(const std::string& path)> choices{};
  /// Whether settings with this number for the setting of a path would be accepted; may be empty.
  std::function<bool(const std::string& path, int value)> accepts{};

  template <class Value>
  bool operator()(const std::string& path, const About& about, Value& value) const {
    const std::string label = label_of(path);
    if constexpr (std::is_enum_v<Value>) {
      const std::vector<std::string_view> names(names_of<Value>.begin(), names_of<Value>.end());
      auto at = static_cast<std::size_t>(value);
      if (!choice_row(label, about, names, at)) return false;
      value = static_cast<Value>(at);
      return true;
    } else if constexpr (std::is_same_v<Value, bool>) {
      return switch_row(label, about, value);
    } else if constexpr (std::is_same_v<Value, std::string>) {
      return text_row(label, about, value, choices ? choices(path) : std::vector<std::string>{});
    } else if constexpr (std::is_same_v<Value, int>) {
      if (accepts && about.most - about.least <= 8)
        return few_row(label, about, value, [&](int tried) { return accepts(path, tried); });
      return number_row(label, about, value);
    } else if constexpr (std::is_arithmetic_v<Value>) {
      return number_row(label, about, value);
    } else {
      return other(path, about, value);
    }
  }

 private:
  template <std::size_t Count>
  bool other(const std::string& path, const About& about, std::array<double, Count>& value) const {
    return numbers_row(label_of(path), about, value);
  }
  bool other(const std::string&, const About&, std::vector<PlacedLight>&) const { return false; }
  template <class Value>
  bool other(const std::string& path, const About& about, std::optional<Value>& value) const {
    ImGui::PushID(path.c_str());
    bool given = value.has_value();
    bool changed = given_row(label_of(path), given);
    if (changed) {
      if (given)
        value.emplace(first_value<Value>(about));
      else
        value.reset();
    }
    if (value) {
      ImGui::SameLine();
      changed |= (*this)(path, about, *value);
    } else {
      ImGui::SameLine();
      ImGui::TextDisabled("%s: %s", label_of(path).c_str(), std::string(about.none).c_str());
      show_help(about);
    }
    ImGui::PopID();
    return changed;
  }
  // Returns the first value of an optional: 0 if that is in range.
  template <class Value>
  static Value first_value(const About& about) {
    if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>)
      return about.least > 0 ? static_cast<Value>(about.least < 1 && about.most >= 1 ? 1 : about.least)
                             : Value{};
    else
      return Value{};
  }
};

}  // namespace dermis::viewer
