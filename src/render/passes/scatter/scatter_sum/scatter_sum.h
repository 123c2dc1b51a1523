// SPDX-License-Identifier: MIT
/// The blurred light of the mapped terms of one skin mesh, weighted and added, and the weight of the rest. A
/// host reads both with dermis/scattered.glsl. Two layers per turn of the pool of light maps, so the light of
/// all heads is there at the end of the frame. Departs from the picture: the part of a term that a map holds
/// is that of the texel, not that of the pixel. Based on: [DLE07] sec. 3.4
#pragma once

#include <vector>

#include "render/passes/compute_pass.h"
#include "render/passes/light_map/light_pool.h"
#include "render/passes/light_map/mapped_terms.h"

namespace dermis::passes {

class ScatterSum : public ComputePass {
 public:
  struct Settings {
    MapSquare square;
    std::vector<MapTerm> terms;  ///< 1 to 8, as SkinLook has them
    bool mixes = false;          ///< likewise
  } settings;
  struct In {
    std::vector<frame::TextureId> lights;  ///< RGBA16F pools, one per term
    frame::TextureId stretch;
    /// RGBA16F array as large as the pool: per MapPlace::batch a layer of light and one of the rest
    frame::TextureId sum;
  } in;
  struct Out {
    frame::TextureId sum;
  };
  /// Returns the layer of the light of a batch; its rest is in the next.
  static std::uint32_t layer_of(std::uint32_t batch) { return 2 * batch; }
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  gpu::Buffer terms_;
};

/// Leaves a texture as shaders of the host sample it. Records nothing but what the graph does for it.
class HandOver {
 public:
  struct Settings {
  } settings;
  struct In {
    frame::TextureId texture;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd&, const frame::Resources&, const FrameData&) const {}
};

}  // namespace dermis::passes
