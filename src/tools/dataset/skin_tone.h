// SPDX-License-Identifier: MIT
// The tone of a head's skin, out of its colour map.
// Based on: [CCH91] Chardon, Cretois, Hourseau: Skin colour typology and suntanning pathways. International
// Journal of Cosmetic Science 13, 1991
#pragma once

#include <array>
#include <optional>

#include "dermis/asset.h"

namespace dermis::dataset {

/// Classes of the individual typology angle, from the fairest: over 55 degrees, 41, 28, 10, -30, and the rest
/// [CCH91].
inline constexpr std::array ita_classes{"very light", "light", "intermediate", "tan", "brown", "dark"};
const char* ita_class(double ita_deg);

/// Returns the typology angle, degrees, of the asset's skin as an instrument measures it without gloss: the
/// median over the area of its skin, so that lips and stubble do not count. None: it has no skin.
std::optional<double> ita_deg_of(const Asset& asset);

}  // namespace dermis::dataset
