// SPDX-License-Identifier: MIT
// Surfaces other than skin, on the device: vertices, triangles and placements of
// all parts in a few large buffers. There is one draw per mesh and material, however many nodes show it. So
// the cost of a frame depends on its triangles and materials, not on nodes.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "gpu/cmd.h"
#include "gpu/resources.h"
#include "head/scene/asset_data.h"
#include "head/scene/rig/rig.h"
#include "render/passes/bindings.h"
#include "render/shared/placement_io.h"

namespace dermis::passes {

struct GpuSurfaces {
  /// Large scenes need several pages, because shaders can address only a limited range of a buffer.
  struct Page {
    gpu::Buffer vertices;        ///< VertexIo[]
    gpu::Buffer vertex_extras;   ///< VertexExtraIo[]
    gpu::Buffer indices;         ///< uint[], into all vertices of the page
    gpu::Buffer placements;      ///< PlacementIo[]; the first leaves vertices where they are
    gpu::Buffer label_vertices;  ///< LabelVertexIo[]; empty until labels are drawn
    /// Where vertices and placements come from, for poses: primitives in the order of their vertices, and the
    /// copy of one behind each placement but the first.
    struct Part {
      std::uint32_t primitive = 0, first_vertex = 0;
    };
    struct Copy {
      std::uint32_t primitive = 0, copy = 0;
    };
    std::vector<Part> parts;
    std::vector<Copy> copies;
  };
  struct Draw {
    std::uint32_t first_index = 0, index_count = 0;
    std::uint32_t first_placement = 0, placements = 1;
  };
  /// Draws that need the same bindings.
  struct Group {
    std::uint32_t page = 0;
    int material = 0;
    std::vector<Draw> draws;
  };
  /// One copy of a blended part; drawn from far to near.
  struct Blended {
    glm::vec3 centre_m{0};  ///< of its bounding box
    std::uint32_t page = 0;
    int material = 0;
    Draw draw;
  };

  std::vector<Page> pages;
  std::vector<Group> groups;  ///< opaque and cut-out parts
  std::vector<Blended> blended;

  /// Records a draw of a group of `page`; its bindings are bound.
  void record(gpu::Cmd& cmd, std::uint32_t page, const Draw& draw) const;
};

/// Returns the placements of a page in a pose of its asset's rig, the first of which moves nothing.
std::vector<io::PlacementIo> posed_placements(const GpuSurfaces::Page& page, const scene::AssetData& scene,
                                              const scene::PosedRig& pose);

/// Uploads everything that is not skin, and skin without texture coordinates, which cannot be unwrapped.
/// Throws DeviceError if memory does not suffice.
GpuSurfaces upload_surfaces(gpu::Device& device, const scene::AssetData& scene);

/// Returns one placement that leaves vertices where they are.
gpu::Buffer unmoved(gpu::Device& device);

}  // namespace dermis::passes
