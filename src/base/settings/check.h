// SPDX-License-Identifier: MIT
// Holds settings against the ranges and names of their rows.
#pragma once

#include <string>

#include "base/core/fields.h"
#include "dermis/compare.h"
#include "dermis/profile.h"
#include "dermis/reference.h"
#include "dermis/scene.h"
#include "dermis/settings.h"

namespace dermis {

/// InputError names the setting, its range and the value: "camera.fov_deg must be 0.1 to 170 degrees, got
/// 300".
void check_ranges(const RenderSettings& settings);
void check_ranges(const SceneOptions& options);
void check_ranges(const ReferenceSettings& settings);
void check_ranges(const SceneComparisonSettings& settings);
void check_ranges(const ProfileOptions& options);
void check_ranges(const Coefficients& coefficients);
void check_ranges(const SpectralSkin& skin, const std::string& where = {});

/// Holds a number against the range of a row. `where`: the place that the error names first, or empty.
void check_number(const std::string& name, const About& about, double number, const std::string& where = {});

/// Holds a number against the row of a member: for what computes with that number under a structure of its
/// own.
template <class Settings, class Type>
void check_member(Type Settings::*member, double number, const std::string& where = {}) {
  const auto one = [&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.member), Type Settings::*>)
      if (field.member == member) check_number(std::string(field.name), field.about, number, where);
  };
  std::apply([&](const auto&... field) { (one(field), ...); }, fields_of<Settings>);
}

/// "0.1 to 170 degrees"; empty if the row bounds nothing.
std::string range_text(const About& about);

}  // namespace dermis
