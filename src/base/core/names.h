// SPDX-License-Identifier: MIT
// Enumerations that people write by name: one table of names for each, from which all else follows.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "base/core/error.h"
#include "base/core/known_names.h"

namespace dermis {

/// The names of an enumeration's values, in its order. Specialised where the enumeration gets its names.
template <class Enum>
inline constexpr std::array<std::string_view, 0> names_of{};

template <class Enum>
std::string_view name_of(Enum value) {
  return names_of<Enum>.at(static_cast<std::size_t>(value));
}

/// InputError says `what` it is that is not known, and lists the names.
template <class Enum>
Enum find_name(std::string_view what, std::string_view name) {
  const auto found = std::find(names_of<Enum>.begin(), names_of<Enum>.end(), name);
  if (found == names_of<Enum>.end()) throw input_error("", "{} {}", what, unknown_name(name, names_of<Enum>));
  return static_cast<Enum>(found - names_of<Enum>.begin());
}

}  // namespace dermis
