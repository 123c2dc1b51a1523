// SPDX-License-Identifier: MIT
// Volume fractions in a map of 8 bits: evenly in their logarithms, because equal
// ratios look about equal.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tissue/optics/skin_table.h"

namespace dermis::pigments {

struct Coding {
  double least = 0, most = 1;  ///< fractions of 0 and of 255

  double fraction(std::uint8_t code) const { return least * std::pow(most / least, code / 255.0); }
  std::uint8_t code(double fraction) const {
    const double share = std::log(std::clamp(fraction, least, most) / least) / std::log(most / least);
    return static_cast<std::uint8_t>(std::lround(255 * share));
  }
};

inline constexpr Coding melanin_coding{optics::least_melanin, optics::most_melanin};
inline constexpr Coding haemoglobin_coding{optics::least_blood, optics::most_blood};

}  // namespace dermis::pigments
