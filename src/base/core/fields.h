// SPDX-License-Identifier: MIT
// A setting is written once: its member, and a row that says what it is. Range checks, options of the command
// line, JSON and the table of the docs iterate over the rows:
//
//   template <>
//   inline constexpr auto fields_of<CameraSettings> = std::tuple{
//       Field{"fov_deg", &CameraSettings::fov_deg,
//             {.help = "vertical field of view", .unit = "degrees", .least = 0.1, .most = 170}}};
//
// A member whose type has fields of its own is a section.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace dermis {

/// Properties of a row beside name and member. The default is that of the member.
struct About {
  std::string_view help;         ///< of a section: its title
  std::string_view unit = {};    ///< of a number; empty: none
  std::string_view values = {};  ///< of a text: words, and in capitals what else it may be, '|' between them
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool open = false;                   ///< neither `least` nor `most` itself is in range
  std::string_view none = {};          ///< in place of an optional without a value, or of an empty text
  std::string_view option = {};        ///< its name on the command line, without dashes; empty: it has none
  std::string_view on = {}, off = {};  ///< words of a switch; empty: its option is a flag
  bool common = false;                 ///< among the few that most people need: help shows these first
  bool rebuilds = false;               ///< whether a change may make the plan of a frame anew
  bool real_time = false;              ///< whether it concerns the real-time techniques alone
};

template <class Settings, class Type>
struct Field {
  std::string_view name;
  Type Settings::*member;
  About about;
};

template <class Settings, class Type>
Field(std::string_view, Type Settings::*, About) -> Field<Settings, Type>;

/// The rows of a structure, in the order of its members; specialised where they are written.
template <class Settings>
inline constexpr std::tuple<> fields_of{};

/// A setting of versions before, or a value of one. Files may still have it; it is left out, with a warning.
struct Gone {
  std::string_view name, value = {};  ///< no value: the setting itself
  std::string_view instead;           ///< the rest of the warning
};
template <class Settings>
inline constexpr std::array<Gone, 0> gone_from{};

template <class Type>
inline constexpr bool has_fields =
    !std::is_same_v<std::remove_cvref_t<decltype(fields_of<Type>)>, std::tuple<>>;

template <class Type>
inline constexpr bool is_optional = false;
template <class Type>
inline constexpr bool is_optional<std::optional<Type>> = true;

inline std::string path_of(std::string_view parent, std::string_view name) {
  return parent.empty() ? std::string(name) : std::string(parent) + "." + std::string(name);
}

/// Calls visit(path, about, value, section) for each setting; `section` is the title of the innermost one.
template <class Settings, class Visit>
void for_each_setting(Settings& settings, const Visit& visit, std::string_view parent = {},
                      std::string_view section = {}) {
  const auto one = [&](const auto& field) {
    auto& value = settings.*field.member;
    const std::string path = path_of(parent, field.name);
    if constexpr (has_fields<std::remove_cvref_t<decltype(value)>>)
      for_each_setting(value, visit, path, field.about.help);
    else
      visit(path, field.about, value, section);
  };
  std::apply([&](const auto&... field) { (one(field), ...); }, fields_of<std::remove_const_t<Settings>>);
}

}  // namespace dermis
