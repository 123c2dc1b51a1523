// SPDX-License-Identifier: MIT
/// What all techniques share: the targets on the screen, the parts that are not skin, and how a frame ends.
#pragma once

#include "techniques/technique.h"

namespace dermis::techniques {

class Screen {
 public:
  Screen(frame::FramePlan& plan, const FrameSettings& settings);

  frame::TextureId colour() const { return colour_; }
  frame::TextureId depth() const { return depth_; }
  frame::TextureId shadow() const { return shadow_; }
  /// Valid with translucency unless all_enters: see passes::Shadow.
  frame::TextureId entering() const { return entering_; }
  frame::BufferId counters() const { return counters_; }
  bool take_clear();  ///< true once: for the pass that draws first

  void add_shadow(std::uint32_t head);
  void add_surfaces(std::uint32_t head);  ///< opaque, then blended
  FrameOutputs finish();                  ///< resolve, bloom, tone map

 private:
  frame::FramePlan* plan_;
  FrameSettings settings_;
  frame::TextureId colour_, depth_, shadow_, entering_;
  frame::TextureId entering_depth_;  // valid if what enters is drawn apart from the shadow maps
  frame::BufferId counters_;
  bool cleared_ = false;
};

/// "shadow" for one head, "shadow head 3" in a crowd; and for one of a head's skin meshes, "irradiance head 3
/// part 1".
std::string label(std::string_view what, const FrameSettings& settings, std::uint32_t head);
std::string label(std::string_view what, const FrameSettings& settings, std::uint32_t head,
                  std::uint32_t mesh);

}  // namespace dermis::techniques
