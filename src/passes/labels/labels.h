// SPDX-License-Identifier: MIT
/// Writes what each pixel shows: one sample at its middle, of the opaque and cut-out parts of all visible
/// instances.
#pragma once

#include <cstddef>

#include "frame/graph.h"
#include "passes/frame_data.h"
#include "passes/labels/labels_io.h"

namespace dermis::passes {

class Labels {
 public:
  struct Settings {
    std::uint32_t width = 0, height = 0;  ///< of the picture, pixels
  } settings;
  struct In {
  } in;
  struct Out {
    frame::TextureId surface;  ///< RGBA32F, LabelSurfaceIo
    frame::TextureId names;    ///< RGBA32UI, LabelNamesIo
    frame::TextureId motion;   ///< RG32F, pixels since the frame before, y down
    frame::TextureId body;     ///< RGBA32F, LabelBodyIo
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  /// Needs GpuMesh::label_vertices of every skin mesh, and Instance::before.
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void draw_skin(gpu::Cmd& cmd, const FrameData& frame, const Instance& instance) const;
  void draw_surfaces(gpu::Cmd& cmd, const FrameData& frame, const Instance& instance) const;
  const gpu::Pipeline* pipeline_of(const GpuMaterial& material, bool skin) const;

  Out out_;
  frame::TextureId depth_;
  const gpu::Pipeline* pipelines_[2][2][2] = {};  // [skin][double sided][cut out]
};

}  // namespace dermis::passes
