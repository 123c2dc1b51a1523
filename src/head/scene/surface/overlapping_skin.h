// SPDX-License-Identifier: MIT
// Finds skin that cannot share a light map: materials of one node whose charts
// lie at the same place. Characters have them whose head and body each fill a map of their own.
#pragma once

#include <string>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Gives skin primitives maps of their own (Primitive::own_light_map), by material, where another skin
/// material of their node covers the same texture coordinates. Charts that meet at a border share. Throws
/// InputError if that makes more light maps than can be drawn; `file` is for the message.
void part_overlapping_skin(const std::string& file, AssetData& scene);

}  // namespace dermis::scene
