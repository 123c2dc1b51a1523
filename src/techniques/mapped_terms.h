// SPDX-License-Identifier: MIT
/// Which terms of the profile are blurred for a head: those that its pixels read.
#pragma once

#include <cstdint>
#include <vector>

#include "passes/mapped_terms.h"
#include "techniques/technique.h"

namespace dermis::techniques {

/// Returns the terms of skin mesh `mesh` of the plan that light maps of `side` x `side` texels (T) are read
/// for. All, unless FrameSettings::terms_by_need().
passes::MappedTerms mapped_terms(const FrameSettings& settings, std::uint32_t mesh, std::uint32_t side);

/// Returns those of each skin mesh of a model.
std::vector<passes::MappedTerms> mapped_terms_of(const FrameSettings& settings, const Model& model,
                                                 std::uint32_t side);

/// Returns how many terms a skin mesh reads from such maps.
int mapped_count(const FrameSettings& settings, std::uint32_t mesh, std::uint32_t side);

}  // namespace dermis::techniques
