// SPDX-License-Identifier: MIT
/// Draws an object on the screen: final.glsl. And counts what it reads though it was never lit.
/// Based on: [DLE07] sec. 3.4; GPU Gems 3, ch. 14.4.6
#pragma once

#include <array>
#include <map>
#include <vector>

#include "passes/lighting.h"
#include "passes/transmission.h"
#include "techniques/published/final_io.h"
#include "techniques/published/object.h"
#include "techniques/technique.h"

namespace dermis::techniques::papers {

class Final {
 public:
  struct Settings {
    Object object;
    SkinPart part;
    std::uint32_t samples = 1;       ///< of the targets
    passes::PictureFormat format;    ///< of the targets
    std::uint32_t largest_side = 0;  ///< T_max
    bool clear = false;              ///< this pass is the first to draw into them
    bool environment = false, soft_shadows = false;
    bool mixes = false;  ///< narrow terms are lit per pixel where T is smaller than T_max
    std::optional<passes::ThroughMesh> through;
  } settings;
  struct In {
    std::vector<frame::TextureId> lights;  ///< RGBA16F, one per term of the profile
    frame::TextureId shadow, entering;
    frame::TextureId colour, depth;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  // How a draw is lit; `off_map`: its triangles have no chart of the unwrap, and are lit without scattering.
  enum class Lit : std::uint8_t { on_map, mixed, at_pixel, off_map };
  std::vector<Lit> ways_to_light() const;
  Lit lit_of(const FrameData& frame, bool on_map) const;
  float share_at_pixel(std::size_t term, const FrameData& frame) const;
  bool through(Lit lit) const { return settings.through && lit != Lit::on_map; }
  gpu::GraphicsDesc desc_of(Lit lit) const;
  io::PaperFinalIo io_of(const FrameData& frame) const;
  void offer(passes::Bindings& bindings, const frame::Resources& resources, const FrameData& frame) const;

  std::map<Lit, std::array<std::array<const gpu::Pipeline*, 2>, passes::SkinKind::count>>
      pipelines_;  // [kind of material][double sided]
  passes::LightingSamplers samplers_;
  passes::ThroughBindings through_;
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
    std::vector<frame::TextureId> lights;  ///< as Final; the first that is read
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
