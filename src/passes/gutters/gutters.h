// SPDX-License-Identifier: MIT
/// Refreshes the texels beside texture seams from the other side (scene/gutters.h makes the list).
#pragma once

#include "passes/light_pool.h"

namespace dermis::passes {

class Gutters {
 public:
  enum class What : std::uint8_t { light, stretch };
  struct Settings {
    /// stretch: one, at the origin, of the texture's size whatever the instance's T
    std::vector<MapSquare> squares;
    What what = What::light;
    frame::Runs runs = frame::Runs::every_frame;  ///< once: of a map that lasts
  };
  struct In {
    frame::TextureId target;  ///< RGBA16F pool, changed in place
  };
  struct Out {
    frame::TextureId target;
  };
  explicit Gutters(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void refresh(gpu::Cmd& cmd, const gpu::Texture& target, const GpuMesh& mesh, glm::uvec2 origin,
               std::uint32_t side) const;
  Settings settings_;
  In in_;
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
