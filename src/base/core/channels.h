// SPDX-License-Identifier: MIT
// Names of the three channels of a colour, for messages.
#pragma once

#include <array>

namespace dermis {

inline constexpr std::array channel_names = {"red", "green", "blue"};

}  // namespace dermis
