// SPDX-License-Identifier: MIT
// Relief of skin below a texel of its maps, as a tile. Based on: Hashimoto: New methods for surface
// ultrastructure: comparative studies of scanning electron microscopy, transmission electron microscopy and
// replica method. International Journal of Dermatology 13, 1974 (primary lines 20 to 100 um deep around
// plateaus, secondary lines between them).
#pragma once

#include "image/image.h"

namespace dermis::builtin_head {

/// The tile covers one part in this many of the chart along each axis: about 20 mm of the face.
inline constexpr int tiles_per_chart = 16;

/// Returns the tile as normals in tangent space, +Y up, without a seam at its borders: a net of fine lines,
/// 0.5 mm apart, across plateaus that are not flat. The same bits everywhere.
image::Image8 microrelief(int side);

}  // namespace dermis::builtin_head
