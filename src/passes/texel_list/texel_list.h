// SPDX-License-Identifier: MIT
/// Lists the texels that a frame lights, material by material, for passes that start no workgroup without
/// one. Lists of one material only are made in one go. Where some skin mesh has several materials, texels are
/// counted first: CountTexels, TexelRanges, ListTexels; else ListTexels, TexelRanges.
#pragma once

#include <vector>

#include "passes/compute_pass.h"
#include "passes/kept_triangles.h"
#include "passes/light_pool.h"
#include "passes/texel_lists.h"

namespace dermis::passes {

/// Counts or lists texels whose triangle is not culled.
class ListTexels : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    bool counts_only = false;
  } settings;
  struct In {
    TexelLists lists;
    frame::TextureId texels;  ///< of TexelMap
    KeptTriangles kept = {};  ///< not valid: nothing is culled
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Gives each list that was counted its place and its indirect dispatch.
class TexelRanges : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  } settings;
  struct In {
    TexelLists lists;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
