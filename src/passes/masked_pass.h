// SPDX-License-Identifier: MIT
/// Common part of convolutions over the squares of a light map: how they skip texels without light.
/// Based on: [JG08] sec. 3
#pragma once

#include <string>

#include "frame/graph.h"
#include "gpu/cmd.h"
#include "gpu/pipelines.h"
#include "passes/bindings.h"
#include "passes/light_mask.h"
#include "passes/light_pool.h"

namespace dermis::passes {

/// A pass of two shaders, NAME.frag (masked_drawn.glsl) and NAME.comp (masked_computed.glsl), of which the
/// mask chooses one. Its push constants have `origin`, `side`, `square` and `first_tile`, which run() fills
/// in.
class MaskedPass {
 public:
  void prepare(gpu::PipelineLibrary& library);

 protected:
  /// Declares the shaders, the mask, and the RGBA16F pool that is written.
  void masked(frame::Declare& d, std::string shader, const LightMask& mask, frame::TextureId target);
  const gpu::Pipeline& pipeline() const { return *pipeline_; }

  /// Offers what skips unlit texels, and the target. unused: a buffer that is bound in place of lists that
  /// are not read.
  void offer(Bindings& bindings, const frame::Resources& resources, const gpu::Buffer& unused) const;
  template <class Io>
  void run(gpu::Cmd& cmd, const frame::Resources& resources, const UsedSquare& square, Io io) const {
    io.origin = square.origin;
    io.side = square.side;
    io.square = square.index;
    io.first_tile = square.index * mask_.lists.room;
    cmd.push(pipeline(), io);
    run_over(cmd, resources, square);
  }

 private:
  bool tiled() const { return mask_.skip_unlit == SkipUnlit::by_tiles; }
  bool drawn() const { return mask_.skip_unlit != SkipUnlit::never && !tiled(); }
  void run_over(gpu::Cmd& cmd, const frame::Resources& resources, const UsedSquare& square) const;
  void draw(gpu::Cmd& cmd, const frame::Resources& resources, VkRect2D area) const;
  std::string shader_;
  LightMask mask_;
  frame::TextureId target_;
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
