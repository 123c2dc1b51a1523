// SPDX-License-Identifier: MIT
/// T, the side of the light maps of a head; and the steps in which sides fall, those of shadow maps too.
#pragma once

#include <cstdint>
#include <vector>

#include "render/techniques/technique.h"

namespace dermis::techniques {

/// Returns the sides that light maps by need have, large to small: 2^k and 3 * 2^(k-1) texels, from `most`
/// (which may be another) down to 32.
std::vector<std::uint32_t> sides_by_need(std::uint32_t most);

/// Returns the smallest of those that has as many texels; `most`, if none has.
std::uint32_t side_of(double texels, std::uint32_t most);

/// Returns the side of maps that hold the wide terms of a skin mesh, at most `most`. Light spreads over these
/// further than 1 mm, or further than half as far as over the widest; what narrower terms spread shows in
/// close-ups alone.
std::uint32_t near_side(const PlannedMesh& part, std::uint32_t most);

/// Returns T of a head with FrameSettings::mixes(): of sides_by_need(), at most `most`, large enough for the
/// terms that spread light over enough pixels (mapped_terms.h). pixels_per_mm: of the asset, where it is
/// nearest.
std::uint32_t side_by_need(const FrameSettings& settings, const Model& model, double pixels_per_mm,
                           std::uint32_t most);

}  // namespace dermis::techniques
