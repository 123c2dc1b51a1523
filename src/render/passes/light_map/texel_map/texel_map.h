// SPDX-License-Identifier: MIT
/// Draws which triangle each texel of a light map shows, for passes that compute what is there. It does not
/// depend on the camera, and lasts until its square holds another T or another unwrap (kept_maps.h). Based
/// on: Burns, Hunt: The Visibility Buffer, JCGT 2(2), 2013 (triangles are stored, and their vertices' values
/// computed again where they are needed)
#pragma once

#include <cstdint>
#include <vector>

#include "frame/graph.h"
#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

/// Returns the map of a pool, R32_UINT, which lasts from frame to frame: number of the triangle in
/// GpuMesh::indices, plus one; 0: none. `light`: a texture of the pool that is not halved.
frame::TextureId make_texel_map(frame::FrameGraph& graph, gpu::TextureDesc light);

/// Draws the squares that hold another unwrap or another T (FrameData::kept_texels). Of triangles that share
/// a texel the last one owns it; there are few (head/scene/surface/chart_layers.h).
class TexelMap {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    std::vector<std::uint32_t> unwraps;  ///< number of the unwrap, by skin mesh of the plan
  } settings;
  struct In {
    frame::TextureId map;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  bool must_draw(const FrameData& frame, const UsedSquare& square) const;
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
