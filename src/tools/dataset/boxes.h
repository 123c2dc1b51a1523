// SPDX-License-Identifier: MIT
// Boxes around what masks show.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace dermis::dataset {

/// A connected part of a mask, pixels.
struct Box {
  int x = 0, y = 0, width = 0, height = 0;
  std::uint64_t area = 0;  ///< of the part, not of the box
  bool operator==(const Box&) const = default;
};

/// Returns the box of all pixels of a value in the first channel of rgba16; none: area 0. 0: of all but 0.
Box box_of(const image::Image8& mask, int value);
/// Returns the boxes of the parts of that value which touch by sides, of at least so many pixels, top first.
std::vector<Box> boxes_of_parts(const image::Image8& mask, int value, std::uint64_t least_pixels);

}  // namespace dermis::dataset
