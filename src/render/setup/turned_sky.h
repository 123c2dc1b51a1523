// SPDX-License-Identifier: MIT
/// The sky that the skin of an asset sees, packed for the pass that turns it: render/passes/pose/turn_sky.
#pragma once

#include <cstdint>
#include <vector>

#include "environment/occlusion.h"
#include "head/scene/surface/unwrap.h"
#include "render/shared/turned_sky_io.h"

namespace dermis::setup {

/// Texels of which something is known, and those that repeat them.
struct SkyTexels {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> rows;  ///< SKY_TEXEL_ROWS * count, see render/shared/turned_sky_io.h
};
/// `occlusion`: of this mesh.
SkyTexels sky_texels(const scene::SkinMesh& mesh, const environment::Occlusion& occlusion);

/// The environment in the coordinates of an asset.
io::SkyHarmonicsIo sky_harmonics_io(const environment::SkyHarmonics& sky,
                                    const environment::SkyHarmonics& bouncing_sky);

}  // namespace dermis::setup
