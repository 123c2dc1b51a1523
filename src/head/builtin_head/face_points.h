// SPDX-License-Identifier: MIT
// Landmarks of the built-in head: dermis/landmarks.h.
#pragma once

#include <array>

#include "dermis/landmarks.h"
#include "head/scene/asset_data.h"

namespace dermis::builtin_head {

/// Returns the landmarks of a head that make() has made. Lids, corners and inner lips are nodes of the net;
/// the others are the points of the skin that lie nearest to the sculptor's.
std::array<LandmarkPlace, Landmarks::count> landmark_places(const scene::AssetData& head);

}  // namespace dermis::builtin_head
