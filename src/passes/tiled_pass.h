// SPDX-License-Identifier: MIT
/// Common part of convolutions over the squares of a light map: how they skip texels without light.
/// Based on: [JG08] sec. 3, whose masks end fragments; here tiles without light are not dispatched.
#pragma once

#include <string>

#include "frame/graph.h"
#include "gpu/cmd.h"
#include "gpu/pipelines.h"
#include "passes/bindings.h"
#include "passes/light_pool.h"
#include "passes/tile_lists.h"

namespace dermis::passes {

/// A pass of a shader that ends with tiled_pass.glsl. Its push constants have `origin`, `side`, `square` and
/// `first_tile`, which run() fills in.
class TiledPass {
 public:
  void prepare(gpu::PipelineLibrary& library);

 protected:
  /// Declares the shader, the tiles that hold light (none: all of the used square is computed), and the
  /// RGBA16F pool that is written.
  void tiled(frame::Declare& d, std::string shader, const TileLists& lit, frame::TextureId target);
  const gpu::Pipeline& pipeline() const { return *pipeline_; }

  /// Offers the lists of tiles, and the target. unused: a buffer that is bound in place of lists that are not
  /// read.
  void offer(Bindings& bindings, const frame::Resources& resources, const gpu::Buffer& unused) const;
  template <class Io>
  void run(gpu::Cmd& cmd, const frame::Resources& resources, const UsedSquare& square, Io io) const {
    io.origin = square.origin;
    io.side = square.side;
    io.square = square.index;
    io.first_tile = square.index * lit_.room;
    cmd.push(pipeline(), io);
    dispatch(cmd, resources, square);
  }

 private:
  void dispatch(gpu::Cmd& cmd, const frame::Resources& resources, const UsedSquare& square) const;
  std::string shader_;
  TileLists lit_;
  frame::TextureId target_;
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
