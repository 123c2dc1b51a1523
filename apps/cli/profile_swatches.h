// SPDX-License-Identifier: MIT
/// The range of spectral skin as a picture.
#pragma once

#include "image/image.h"
#include "tissue/optics/skin.h"

namespace dermis::cli {

/// Columns: melanin 0.001 to 0.5 (log), 12 of them; rows: haemoglobin 0.001 to 0.1 (log), 8; all else from
/// `fixed`. Each swatch is 48 pixels wide, sRGB of optics::skin_colour(). About a second.
image::Image8 skin_swatches(const SpectralSkin& fixed);

}  // namespace dermis::cli
