// SPDX-License-Identifier: MIT
// Shapes of skin that show what a technique cannot do, generated. No lights, no cameras, no maps. Metres.
#pragma once

#include "head/scene/asset_data.h"

namespace dermis::cli::test_scenes {

/// A square of 0.3 m in the plane z = 0 that faces +Z. Skin is white where it is lit and black elsewhere, in
/// two materials of one head; the whole albedo acts before light scatters. So the light that enters has an
/// edge that no shadow map blurs. Nothing is reflected at the surface.
///
/// `lit`: x below `edge_m`, or y below it.
enum class LitHalf { below_x, below_y };
scene::AssetData lit_half_plane(LitHalf lit, double edge_m);

/// A cheek, 0.2 m wide, with a ridge of 28 mm along y, as a nose has: it hides what lies behind it from a
/// camera at the side.
scene::AssetData nose_on_cheek();

/// A lens of 40 x 64 mm that is 3 mm thick in its middle, as an ear is: light comes through it.
scene::AssetData thin_lens();

/// A shell 3 mm thick, rolled along y to an open curl of 270 degrees, as the helix of an ear is; its ends are
/// closed. The gap faces +X.
scene::AssetData open_curl();

/// Fingers of 0.8 to 3 mm that stand beside each other, each a little more tilted: silhouettes everywhere.
scene::AssetData fringe();

}  // namespace dermis::cli::test_scenes
