// SPDX-License-Identifier: MIT
/// How passes make a picture. A technique is a function that adds passes to a plan; the list in all.cpp is the only register.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frame/plan.h"
#include "gaussians/sum.h"
#include "passes/view/view.h"

namespace dermis::techniques {

/// One skin mesh as the plan needs to know it.
struct SkinPart {
  gaussians::SumOfGaussians profile;
  double max_texels_per_mm = 1;  ///< where its unwrap is densest, at the map size of the frame
  int gutter_texels = 0;         ///< how far a blur step reaches past a seam; see gutter_width()
};

/// The structure of a frame: a change makes a new plan. What changes per frame is frame::FrameData.
struct FrameSettings {
  std::uint32_t width = 1280, height = 720;
  std::uint32_t samples = 4;         ///< 1 or 4
  std::uint32_t map_size = 2048;     ///< T, texels
  std::uint32_t shadow_size = 2048;  ///< texels
  std::uint32_t shadow_layers = 1;   ///< of one head, at least 1
  std::uint32_t heads = 1;
  std::vector<SkinPart> skin;  ///< one a skin mesh of the scene
  bool has_surfaces = false, has_blended = false;
  float bloom = 0;  ///< 0..1
  passes::ViewTransform view = passes::ViewTransform::filmic;
};

/// Slots of FrameOutputs::counters.
enum Counter : std::uint32_t { counter_irradiance = 0, counter_skin_pixels = 1, counter_count = 2 };

struct FrameOutputs {
  frame::TextureId picture;                       ///< RGBA16F, linear, with bloom; alpha = share of the pixel that is skin
  frame::TextureId display;                       ///< RGBA8, after the view transform
  frame::BufferId counters;                       ///< uint[counter_count]
  std::map<std::string, frame::TextureId> shows;  ///< what `--show` can show: "irradiance", "blur:0", ...
  std::uint64_t launched_per_head = 0;            ///< compute invocations of the convolution of one head
};

struct Technique {
  std::string_view name;
  std::string_view summary;  ///< one line
  bool scatters = true;      ///< uses the profile
  FrameOutputs (*build)(frame::FramePlan& plan, const FrameSettings& settings);
};

std::span<const Technique> techniques();
/// InputError lists the names when there is none such.
const Technique& find_technique(std::string_view name);

}  // namespace dermis::techniques
