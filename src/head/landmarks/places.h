// SPDX-License-Identifier: MIT
/// Places of landmarks in an asset as it is kept.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "head/landmarks/sidecar.h"
#include "head/scene/asset_data.h"

namespace dermis::landmarks {

/// A vertex of the asset as it is kept.
struct KeptVertex {
  std::size_t primitive = 0;  ///< number in AssetData::primitives
  std::uint32_t vertex = 0;
};

using KeptPlaces = std::array<std::array<KeptVertex, 3>, Landmarks::count>;

/// Returns why these landmarks are not those of the asset, one line; empty: they are. The meshes must have
/// the sizes that the sidecar says, and each point's triangle.
std::string misfit(const Sidecar& sidecar, const scene::AssetData& asset);

/// Returns where the corners are kept; the sidecar must fit.
KeptPlaces kept_places(const Sidecar& sidecar, const scene::AssetData& asset);

/// Returns the size of a mesh of the asset's source.
MeshSize size_of(const scene::AssetData& asset, int mesh);

}  // namespace dermis::landmarks
