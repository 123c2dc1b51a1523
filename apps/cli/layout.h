// SPDX-License-Identifier: MIT
/// Several heads beside each other.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "base/core/names.h"
#include "dermis/scene.h"

namespace dermis::cli {

enum class Layout : std::uint8_t {
  row,  ///< from left to right
  grid  ///< rows of as many, nearly as many as rows, from the top
};

/// Returns where the centres of the spheres around heads stand, right and up, in metres: neighbours 1.6 radii
/// of the larger one apart, rows of a grid 2 radii. Number floor(n / 2) is at the origin.
std::vector<std::array<double, 2>> places_m(Layout layout, const std::vector<double>& radii_m);

/// Returns a scene of these assets, upright and beside each other, the middle one where its file has it. It
/// has no lights: those of several files have no common world.
Scene laid_out(const std::vector<Asset>& assets, Layout layout);

}  // namespace dermis::cli

template <>
inline constexpr std::array<std::string_view, 2> dermis::names_of<dermis::cli::Layout>{"row", "grid"};
