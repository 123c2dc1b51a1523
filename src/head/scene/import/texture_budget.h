// SPDX-License-Identifier: MIT
// Selects the pictures of a source that a scene keeps, and their sizes: all maps
// together stay within a budget.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "head/scene/asset_data.h"
#include "image/shrink.h"

namespace dermis::scene {

/// Returns the memory of a map: its pixels, 4 bytes each, and its mip levels on the device, 4/3 times 4 bytes
/// per pixel. These are 8 for colours, which some devices store as half floats.
std::uint64_t map_bytes(int width, int height, bool colour);

/// One use of a picture of the source: as colour or as data.
struct MapUse {
  int source = 0;  ///< number of the picture in its source
  bool colour = false;
  bool deep = false;   ///< heights: see image::Shrink
  std::string name{};  ///< of the picture, for messages
  int full_width = 0, full_height = 0;
  int halvings = 0;
  int image = -1;  ///< index into AssetData::images

  std::pair<int, bool> key() const { return {source, colour}; }
  int width() const;  ///< after halvings
  int height() const;
  std::uint64_t bytes() const;
  image::Shrink shrink() const { return {.halvings = halvings, .srgb = colour, .deep = deep}; }
};

/// Returns each pair of a picture and its use by a material once, in the order of the source; without names
/// and sizes. MapRef::image is still a number of the source.
std::vector<MapUse> map_uses(const AssetData& scene);

/// Points the maps of equal pictures at one of them: `first`, by the number in the source; -1 leaves them
/// out.
void point_maps_at_first(const std::map<int, int>& first, AssetData& scene);

/// Halves the largest map (the first of equal ones) until all are within the budget. One note lists them;
/// `file` is for messages. Throws InputError if they cannot fit.
void fit_to_budget(const std::string& file, std::uint64_t budget_bytes, std::vector<MapUse>& uses);

/// Numbers the images: a picture of full size serves all uses; a picture that is halved is
/// kept for colours and for data, because their averages differ. Returns the use that makes each image; the
/// pointers are into `uses`.
std::vector<const MapUse*> number_images(std::vector<MapUse>& uses);

/// Points the maps of all materials at AssetData::images; those of a use without an image are left out.
void point_maps_at_images(const std::vector<MapUse>& uses, AssetData& scene);

}  // namespace dermis::scene
