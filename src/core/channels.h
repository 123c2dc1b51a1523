// SPDX-License-Identifier: MIT
// What messages call the three channels of a colour.
#pragma once

#include <array>

namespace dermis {

inline constexpr std::array channel_names = {"red", "green", "blue"};

}  // namespace dermis
