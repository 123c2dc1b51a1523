// SPDX-License-Identifier: MIT
/// Common part of all techniques: the targets on the screen, the parts that are not skin, and the end of a
/// frame.
#pragma once

#include <string>
#include <vector>

#include "render/passes/pixels/entries/entries.h"
#include "render/passes/pixels/shade/skin_shading.h"
#include "render/passes/screen/screen_surface.h"
#include "render/techniques/batches.h"
#include "render/techniques/technique.h"

namespace dermis::techniques {

/// Slots of FrameOutputs::counters that every technique has; its own follow.
enum ScreenCounter : std::uint32_t { counter_skin_pixels, screen_counters };

/// One skin mesh of one head.
struct SkinOnScreen {
  passes::SkinLook look;               ///< of which Screen decides the members from `environment` to `kinds`
  std::vector<frame::TextureId> maps;  ///< its light, one per weight of `look`
};

class Screen {
 public:
  /// Makes the targets, for which `counters` is the number of slots, at least screen_counters. `plan` must
  /// outlive this.
  Screen(passes::FramePlan& plan, const FrameSettings& settings, std::size_t counters = screen_counters);

  /// Valid if the frame draws a picture.
  frame::TextureId depth() const { return depth_; }
  frame::TextureId shadow() const { return shadow_; }
  /// Valid with translucency unless all_enters: see passes::Shadow.
  frame::TextureId entering() const { return entering_; }
  frame::BufferId counters() const { return counters_; }
  /// Returns what is drawn once per head and light.
  std::vector<frame::TextureId> shadow_maps() const;

  /// Adds the shadow maps of a batch, and with the first one the ids of all skin: a device draws before it
  /// computes.
  void begin_batch(const Batch& batch);
  /// Adds the parts of a batch that are not skin. They take the depth of the ids, which entries are found by.
  void end_batch(const Batch& batch);
  /// Clears these buffers with the ids, too. Before begin_batch(); only if the frame draws a picture.
  void clear_with_ids(const std::vector<frame::BufferId>& buffers) { cleared_with_ids_ = buffers; }
  /// Adds the next of the passes that find and list what the ids show, if any is left. A technique puts them
  /// beside passes of its own, to wait at one barrier; the rest is added with the first skin.
  void add_next_of_entries();
  /// Adds the shadow maps of all lights for the heads of a batch.
  void add_shadows(const Batch& batch);
  /// Adds the shading of skin, in a pass of this name. Needs begin_batch(). Nothing if the frame draws no
  /// picture.
  void add_skin(const std::vector<SkinOnScreen>& skin, const std::string& name);
  /// Adds the count of reads of its maps that find no light, into this slot of the counters. Before
  /// add_skin(), which takes the ids of the entries. Nothing for a host.
  void add_unshaded_reads(const std::vector<SkinOnScreen>& skin, std::uint32_t slot, const std::string& name);
  /// For skin that a pass of the technique draws. colour(): the target of it, or of a layer over it, made at
  /// the first call. take_clear(): true at the first call only; that pass clears colour and depth.
  frame::TextureId colour();
  bool take_clear();
  /// Adds skin shaded in parts, of which `surface` takes what is blurred. blurred: the share of each skin
  /// mesh of the plan. Needs begin_batch().
  void add_split_skin(const std::vector<passes::MapSquare>& skin, const std::vector<gaussians::Rgb>& blurred,
                      const passes::ScreenSurface& surface, const std::string& name);
  /// Adds skin shaded with scattering from tables. curvatures: of each skin mesh of the plan. Needs
  /// begin_batch().
  void add_pre_integrated_skin(const std::vector<passes::MapSquare>& skin,
                               const std::vector<frame::BufferId>& curvatures, std::uint32_t shadow_taps,
                               const std::string& name);
  /// Adds what was blurred to the skin, once all of it is shaded.
  void add_scattered(frame::TextureId blurred, const passes::ScreenSurface& surface);
  /// Returns whether any of these heads has parts that are not skin.
  bool has_other_parts(const Batch& batch) const;
  /// Adds the opaque parts of these heads that are not skin.
  void add_surfaces(const Batch& batch);
  /// Adds their blended parts, far to near, over all that is drawn.
  void add_blended(const Batch& batch);
  /// Adds resolve, background, bloom, tone map and labels, and shows the shadow maps; nothing for a host. The
  /// last call.
  FrameOutputs finish();

 private:
  /// Draws which skin the picture shows, of all heads. Nothing if there is none.
  void add_ids();
  void add_entries() {
    while (entry_passes_left_ > 0) add_next_of_entries();
  }
  void make_shadow_maps();
  gpu::TextureDesc target(VkFormat format) const;
  bool shaded() const { return entries_.entries.valid(); }  // add_ids() has been called
  std::uint32_t first_part(const passes::MapSquare& square) const;
  // Other surfaces are drawn into a layer over it; into a host's targets they are drawn as they are.
  bool layered() const { return shaded() && !settings_.host; }
  // Writes the shaded skin of a batch into the targets of a host.
  void add_composed(const Batch& batch);
  // Fills in what the scene and the skin mesh decide.
  passes::SkinLook look_of(passes::SkinLook asked) const;
  // The same of skin that is wholly lit per pixel, with light through the body.
  passes::SkinLook whole_look_of(const passes::MapSquare& square) const;
  bool reads_open() const;  // the share of the background in each pixel
  frame::TextureId add_picture();
  frame::TextureId add_open_share();
  void add_display(FrameOutputs& out);
  void add_finished_picture(FrameOutputs& out);
  void add_labels(FrameOutputs& out);
  bool any_head(const Batch& batch, bool Model::*has) const;

  passes::FramePlan* plan_;
  FrameSettings settings_;
  // If skin is shaded, colour_ is a layer over it, valid if there is anything in it; but that of a host.
  frame::TextureId colour_, depth_, shadow_, entering_;
  frame::TextureId ids_, ids_depth_;  // if skin is shaded
  frame::TextureId entering_depth_;   // valid if what enters is drawn apart from the shadow maps
  frame::BufferId counters_;
  frame::TextureId
      cover_;  // alpha: what blended surfaces hide of the background; valid if colour_ has no such
  bool cleared_ = false;
  std::vector<frame::BufferId> cleared_with_ids_;
  int entry_passes_left_ = 0;
  passes::EntryBuffers entries_;           // if skin is shaded
  std::vector<std::uint32_t> first_part_;  // of each head, and the number of all
};

/// Technique::maps, report and gutters for techniques without light maps.
FrameOutputs screen_maps(passes::FramePlan& plan, const FrameSettings& settings);
FrameReport screen_report(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                          std::span<const passes::Head> heads);
std::vector<GutterSize> no_gutters(const FrameSettings& settings, std::span<const passes::Head> heads);

/// Draws labels and no light: FrameSettings::picture is false. Not one of techniques().
extern const Technique labels_alone;

/// Returns "stretch" for one skin mesh of the plan, "stretch part 1" for one of several.
std::string label_part(std::string_view what, const FrameSettings& settings, std::uint32_t mesh);

}  // namespace dermis::techniques
