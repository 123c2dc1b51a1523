// SPDX-License-Identifier: MIT
// Downsamples pictures: mip levels for textures, and averages of super-samples.
#pragma once

#include <functional>

#include "image/image.h"

namespace dermis::image {

/// Calls body() for one level after the other: base, then each of half the size (rounded down, at least 1),
/// down to 1 x 1. Every level is the area average of base and is rounded to 8 bits only at its end, so that
/// errors do not add up along the chain. srgb: colours are averaged in linear light and weighted by alpha, so
/// that the invisible colour of cut-out texels (hair cards) does not bleed in. Else all four channels are
/// plain data. base has at least one pixel. Keeps at most two levels in memory.
void for_each_mip(const Image8& base, bool srgb, const std::function<void(const Image8& mip)>& body);

/// Returns the average of factor x factor pixels, summed in double. factor >= 1 must divide both sides.
ImageF downsample_box(const ImageF& picture, int factor);

}  // namespace dermis::image
