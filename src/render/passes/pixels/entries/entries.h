// SPDX-License-Identifier: MIT
/// Entries of skin that a picture has to shade, listed by part, and the picture made of them
/// (render/passes/pixels/entry_buffers.h). Samples of a pixel that show the same part with continuous
/// depth are one entry. Where a pixel shows one surface, but three triangles of it or more, that surface
/// is two. An entry that has its whole pixel keeps the triangle of its last sample, too: it is lit at two
/// points. One indirect dispatch shades a part without idle lanes; the order within its list changes from
/// run to run, and no result depends on it. Then each sample takes the light of its entry, and the mean
/// of the samples is the pixel. Based on: Burns, Hunt: The Visibility Buffer, JCGT 2(2), 2013. Fatahalian
/// et al.: Reducing Shading on GPUs Using Quad-Fragment Merging, SIGGRAPH 2010 (samples of one surface
/// are shaded once)
#pragma once

#include "render/passes/compute_pass.h"
#include "render/passes/pixels/entry_buffers.h"

namespace dermis::passes {

/// Finds the entries of each pixel, at most as many as it has samples, and their ranks.
class Entries : public ComputePass {
 public:
  struct Settings {
  } settings;
  struct In {
    frame::TextureId ids, depth;  ///< of Ids
    EntryBuffers buffers;         ///< parts: cleared before
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  bool multisampled_ = false;
};

/// Gives each part its range of the list of each band, and its indirect dispatch.
class PartRanges : public ComputePass {
 public:
  struct Settings {
  } settings;
  struct In {
    EntryBuffers buffers;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Writes the lists.
class EntryList : public ComputePass {
 public:
  struct Settings {
  } settings;
  struct In {
    EntryBuffers buffers;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Makes the picture from the shaded entries, and what lies over them. Empty beside the heads.
class ResolveEntries : public ComputePass {
 public:
  struct Settings {
    std::uint32_t samples = 1;  ///< of the ids
  } settings;
  struct In {
    EntryBuffers buffers;
    /// Premultiplied light over the skin, alpha is what it hides; not valid: there is none.
    frame::TextureId layer;
  } in;
  struct Out {
    frame::TextureId picture;  ///< RGBA16F, one sample; alpha: share of the pixel that is skin
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void empty(gpu::Cmd& cmd, const gpu::StorageImageBinding& picture, glm::uvec2 low, glm::uvec2 high) const;

  Out out_;
  const gpu::Pipeline* beside_ = nullptr;
};

}  // namespace dermis::passes
