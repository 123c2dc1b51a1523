// SPDX-License-Identifier: MIT
/// Draws the skin of all heads as ids and depth: what each sample shows, before anything is shaded. 16 bits
/// are the part: a run of triangles of one material of a skin mesh of a head. 16 are the triangle, so longer
/// runs are several parts. Id 0 is the background. An id is four bytes in RGBA8, because one software driver
/// multisamples no integer targets. Triangles come from render/shaders/first_corner.glsl, without optional
/// features. Based on: Burns, Hunt: The Visibility Buffer, JCGT 2(2), 2013
#pragma once

#include <vector>

#include "frame/graph.h"
#include "render/passes/frame_data.h"
#include "render/passes/light_map/light_pool.h"
#include "render/shared/entries_io.h"

namespace dermis::passes {

/// Returns the id of the first triangle of a part.
constexpr std::uint32_t first_id(std::uint32_t part) { return (part + 1) << ID_TRIANGLE_BITS; }

class Ids {
 public:
  struct Settings {
    std::uint32_t samples = 1;      ///< of the depth
    bool reversed_depth = true;     ///< near is 1
    bool cut_out = false;           ///< some skin is cut out by its alpha
    std::vector<SkinParts> meshes;  ///< of all heads
    bool whole = false;             ///< clears depth beside the heads, too, which other passes read
  } settings;
  struct In {
    frame::TextureId depth;                ///< cleared here
    std::vector<frame::BufferId> buffers;  ///< lists that passes after it add to, likewise
  } in;
  struct Out {
    frame::TextureId ids;  ///< RGBA8: render/shared/entries_io.h
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipelines_[2][2] = {};  // [double sided][cut out]
  Out out_;
};

}  // namespace dermis::passes
