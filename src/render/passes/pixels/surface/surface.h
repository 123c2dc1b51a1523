// SPDX-License-Identifier: MIT
/// Draws everything that is not skin as glTF metallic-roughness: opaque and cut-out parts, or the blended
/// ones from far to near. Each material is bound once, however many nodes show a mesh
/// (render/passes/asset/gpu_surfaces.h). Based on: Khronos: glTF 2.0 specification, appendix B; Karis:
/// Physically Based Shading on Mobile, 2014 (reflection of the environment)
#pragma once

#include <map>

#include "frame/graph.h"
#include "render/passes/frame_data.h"
#include "render/passes/light_map/lighting.h"
#include "render/passes/targets.h"

namespace dermis::passes {

class Surface {
 public:
  struct Settings {
    std::uint32_t first_head = 0, heads = 1;
    std::uint32_t samples = 1;  ///< of the targets
    PictureFormat format;       ///< of the targets
    bool clear = false;         ///< the first to draw into the targets
    /// `colour` lies over skin that is shaded elsewhere; alpha is what it hides. `depth` is that of
    /// the skin, and not cleared.
    bool layer = false;
    bool environment = false;   ///< light from FrameData::environment, else FrameIo::ambient
    bool soft_shadows = false;  ///< lights with a radius cast penumbrae
    bool blended = false;       ///< draws only the blended parts, over the picture
  } settings;
  struct In {
    frame::TextureId shadow, colour, depth;
  } in;
  struct Out {
    frame::TextureId colour, depth;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void bind(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame, const Head& head,
            std::uint32_t page, int number) const;
  void draw_groups(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                   const Head& head) const;
  void draw_blended(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                    const Head& head) const;

  const gpu::Pipeline* single_sided_ = nullptr;
  const gpu::Pipeline* double_sided_ = nullptr;
  LightingSamplers samplers_;
};

}  // namespace dermis::passes
