// SPDX-License-Identifier: MIT
/// Draws an object on the screen: final.frag. And counts what it reads though it was never lit.
/// Based on: [DLE07] sec. 3.4; GPU Gems 3, ch. 14.4.6
#pragma once

#include <array>
#include <map>
#include <vector>

#include "render/passes/light_map/lighting.h"
#include "render/techniques/published/final_io.h"
#include "render/techniques/published/object.h"
#include "render/techniques/technique.h"

namespace dermis::techniques::papers {

class Final {
 public:
  struct Settings {
    Object object;
    PlannedMesh part;
    std::uint32_t samples = 1;     ///< of the targets
    passes::PictureFormat format;  ///< of the targets
    bool clear = false;            ///< this pass is the first to draw into them
    bool environment = false, soft_shadows = false;
  } settings;
  struct In {
    std::vector<frame::TextureId> lights;  ///< RGBA16F, one per term of the profile
    frame::TextureId shadow;
    frame::TextureId colour, depth;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  gpu::GraphicsDesc desc_of(bool on_map) const;
  io::PaperFinalIo io_of(const FrameData& frame) const;
  void offer(passes::Bindings& bindings, const frame::Resources& resources, const FrameData& frame) const;

  using OfMaterial = std::array<std::array<const gpu::Pipeline*, 2>, passes::SkinKind::count>;
  // [draw has a place on the map][kind of material][double sided]
  std::map<bool, OfMaterial> pipelines_;
  passes::LightingSamplers samplers_;
};

/// Counts the visible fragments whose read weighs a texel that was never lit, for the statistics:
/// unshaded_reads.frag. Follows Final.
class UnshadedReads {
 public:
  struct Settings {
    Object object;
    std::uint32_t samples = 1;
    bool cut_out = false;
    std::uint32_t slot = 0;  ///< of the counters
  } settings;
  struct In {
    frame::TextureId light;  ///< of a term
    frame::TextureId depth;
    frame::BufferId counters;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipelines_[2][2] = {};  // [double sided][cut out]
};

}  // namespace dermis::techniques::papers
