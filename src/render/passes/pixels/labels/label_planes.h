// SPDX-License-Identifier: MIT
/// Writes the labels as the caller of a session reads them: one plane per label, without padding, all in one
/// buffer.
#pragma once

#include <array>
#include <cstdint>

#include "render/passes/compute_pass.h"
#include "render/passes/frame_data.h"
#include "render/passes/pixels/labels/labels.h"

namespace dermis::passes {

class LabelPlanes : public ComputePass {
 public:
  struct Settings {
    std::uint32_t width = 0, height = 0;  ///< of the picture, pixels
    std::uint32_t labels = 0;             ///< LABEL_... bits, at least one
  } settings;
  struct In {
    std::array<frame::TextureId, Labels::most_targets> words;  ///< Labels::Out, of the same labels
  } in;
  struct Out {
    frame::BufferId planes;  ///< as bytes_of_planes() says
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  Out out_;
};

/// Returns where the plane of a label, one bit, lies among these: bytes from the beginning of the buffer.
std::uint64_t plane_offset(std::uint32_t labels, std::uint32_t label, std::uint64_t pixels);
/// Returns the size of the buffer, a multiple of 4 bytes.
std::uint64_t bytes_of_planes(std::uint32_t labels, std::uint64_t pixels);

}  // namespace dermis::passes
