// SPDX-License-Identifier: MIT
/// What all techniques share: the targets on the screen, the parts that are not skin, and how a frame ends.
#pragma once

#include "techniques/batches.h"
#include "techniques/technique.h"

namespace dermis::techniques {

/// Slots of FrameOutputs::counters that every technique has; its own follow.
enum ScreenCounter : std::uint32_t { counter_skin_pixels, screen_counters };

class Screen {
 public:
  /// Makes the targets, for which `counters` is the number of slots, at least screen_counters. `plan` must
  /// outlive this.
  Screen(passes::FramePlan& plan, const FrameSettings& settings, std::size_t counters = screen_counters);

  /// Valid if the frame draws a picture.
  frame::TextureId colour() const { return colour_; }
  frame::TextureId depth() const { return depth_; }
  frame::TextureId shadow() const { return shadow_; }
  /// Valid with translucency unless all_enters: see passes::Shadow.
  frame::TextureId entering() const { return entering_; }
  frame::BufferId counters() const { return counters_; }
  /// Returns what is drawn once per head and light.
  std::vector<frame::TextureId> shadow_maps() const;
  /// Returns true at the first call only: the pass that draws first clears colour and depth.
  bool take_clear();

  /// Adds the shadow maps of all lights for the heads of a batch.
  void add_shadows(const Batch& batch);
  /// Adds the opaque parts of these heads that are not skin.
  void add_surfaces(const Batch& batch);
  /// Adds their blended parts, far to near, over all that is drawn.
  void add_blended(const Batch& batch);
  /// Adds resolve, bloom, tone map and labels, and shows the shadow maps; nothing for a host. The last call.
  FrameOutputs finish();

 private:
  void add_labels(FrameOutputs& out);
  bool any_head(const Batch& batch, bool Model::*has) const;

  passes::FramePlan* plan_;
  FrameSettings settings_;
  frame::TextureId colour_, depth_, shadow_, entering_;
  frame::TextureId entering_depth_;  // valid if what enters is drawn apart from the shadow maps
  frame::BufferId counters_;
  bool cleared_ = false;
};

/// Technique::maps, report and gutters for techniques without light maps.
FrameOutputs screen_maps(passes::FramePlan& plan, const FrameSettings& settings);
FrameReport screen_report(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                          std::span<const DrawnHead> drawn);
std::vector<GutterSize> no_gutters(const FrameSettings& settings, std::span<const DrawnHead> drawn);

/// Returns "stretch" for one skin mesh of the plan, "stretch part 1" for one of several.
std::string label_part(std::string_view what, const FrameSettings& settings, std::uint32_t mesh);

}  // namespace dermis::techniques
