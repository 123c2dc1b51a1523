// SPDX-License-Identifier: MIT
// A colour with other pigments.
#pragma once

#include <array>

#include "head/pigments/fit.h"

namespace dermis::pigments {

/// Returns the 8 bits of a colour whose pigments become others: multiplied by the ratio of the model's
/// albedos.
std::array<std::uint8_t, 3> recoloured(Colour colour, const optics::Pigments& own,
                                       const optics::Pigments& wanted, const optics::SkinTable& table);

}  // namespace dermis::pigments
