// SPDX-License-Identifier: MIT
/// Draws the head on the screen: see skin_shading.h.
/// Based on: [DLE07] sec. 3.4 and GPU Gems 3, ch. 14.4.6
#pragma once

#include "passes/final_pass/skin_shading.h"
#include "passes/targets.h"

namespace dermis::passes {

/// A member of frame::Together.
class FinalPass {
 public:
  struct Settings {
    SkinLook look;
    std::uint32_t samples = 1;  ///< of the targets
    PictureFormat format;       ///< of the targets
    bool clear = false;         ///< this pass is the first to draw into them
  } settings;
  struct In {
    SkinLights lights;
    frame::TextureId colour, depth;
  } in;
  struct Out {
    frame::TextureId colour, depth;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  bool clears() const { return settings.clear; }
  bool draws(const FrameData& frame) const;
  void begin(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame, bool clear) const;
  void draw(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  SkinShading shading_;
  const gpu::Pipeline* pipelines_[SkinVariant::count][2] = {};  // [variant][double sided]
};

/// Counts the visible fragments of the skin whose bilinear read weighs a texel that was never lit, for the
/// statistics. Directly follows FinalPass or Shade with the same squares. A member of frame::Together.
class UnshadedReads {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    std::uint32_t samples = 1;
    bool cut_out = false;    ///< as of FinalPass
    std::uint32_t slot = 0;  ///< of the counters
    TermsOnMap terms;        ///< as of FinalPass
    bool mixes = false;      ///< likewise
  } settings;
  struct In {
    std::vector<frame::TextureId> lights;  ///< RGBA16F pools, one per term
    frame::TextureId depth;
    frame::BufferId counters;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  bool clears() const { return false; }
  bool draws(const FrameData& frame) const;
  void begin(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame, bool clear) const;
  void draw(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  bool reads(const FrameData& frame, const MapSquare& square) const;
  frame::TextureId first_read(const FrameData& frame, const MapSquare& square) const;
  void draw_square(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                   const MapSquare& square) const;
  const gpu::Pipeline* pipelines_[2][2] = {};  // [double sided][cut out]
  gpu::Buffer terms_;                          // SkinTermsIo
};

}  // namespace dermis::passes
