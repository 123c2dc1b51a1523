// SPDX-License-Identifier: MIT
// The rig of an asset on the device: what its vertices hang on, and what morph targets move them by. Shared
// by all its instances; made when the first of them takes a pose.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/resources.h"
#include "head/scene/rig/rig.h"
#include "head/scene/surface/unwrap.h"
#include "render/passes/asset/gpu_surfaces.h"

namespace dermis::passes {

struct GpuRig {
  /// Of one buffer of vertices.
  struct Part {
    gpu::Buffer vertices;    ///< RigVertexIo[]
    gpu::Buffer influences;  ///< InfluenceIo[]
    gpu::Buffer deltas;      ///< MorphDeltaIo[]
    std::uint32_t count = 0;
  };
  /// Of one skin mesh.
  struct Skin {
    gpu::Buffer metric_triangles;     ///< uint[], scene::metric_triangles
    gpu::Buffer touching_neighbours;  ///< uint[], scene::touching_neighbours
    /// uint[] and CurvatureNeighbourIo[], scene::CurvatureStencil; empty until skin that knows its shape
    /// moves
    gpu::Buffer curvature_first, curvature_neighbours;
    /// uint[], render/shared/turned_sky_io.h; empty until an instance in a pose stands in an environment
    gpu::Buffer sky_texels;
    std::uint32_t sky_texel_count = 0;
  };
  std::vector<Part> parts;  ///< one per skin mesh, then one per page of surfaces
  std::vector<Skin> skin;
};

/// Throws DeviceError: more than shaders of the device can read. The scene has a rig.
GpuRig upload_rig(gpu::Device& device, const scene::AssetData& scene, const GpuSurfaces& surfaces);

}  // namespace dermis::passes
