// SPDX-License-Identifier: MIT
// Smaller versions of a picture: mip levels for textures, and the average of super-samples.
#pragma once

#include <functional>
#include <vector>

#include "image/image.h"

namespace dermis::image {

/// The full chain: level 0 is base itself, each further one has half the size (rounded down, at least 1), the
/// last is 1 x 1. Every level is the area average of base; only its final value is rounded to 8 bits, so
/// errors do not add up along the chain. srgb: colours are averaged in linear light and weighted by alpha, so
/// that the invisible colour of cut-out texels (hair cards) does not bleed in; without it all four channels
/// are plain data. base must have at least one pixel.
std::vector<Image8> mip_chain(const Image8& base, bool srgb);
/// The same, one level after the other from the largest on: no more than two of them are in memory at a time.
void for_each_mip(const Image8& base, bool srgb, const std::function<void(const Image8& mip)>& body);

/// The average of factor x factor pixels, summed in double. factor >= 1 must divide both sides.
ImageF downsample_box(const ImageF& picture, int factor);

}  // namespace dermis::image
