// SPDX-License-Identifier: MIT
#include "cli/bench/variants.h"

namespace dermis::cli::bench {
namespace {

RenderSettings with(RenderSettings s, bool cull, bool depth, bool clip) {
  s.technique = "published";
  s.quality.cull = cull, s.quality.depth = depth, s.quality.clip = clip;
  s.quality.skip_unseen_heads = true;
  s.quality.keep_shadows = false;
  return s;
}

RenderSettings by(const char* technique, RenderSettings s) {
  s.technique = technique;
  return s;
}

RenderSettings every_head(RenderSettings s) {
  s = with(s, false, false, false);
  s.quality.skip_unseen_heads = false;
  return s;
}

RenderSettings at_edge(RenderSettings s) {
  s = with(s, true, true, true);
  s.quality.clip_margin_mm = 0;
  return s;
}

RenderSettings still(RenderSettings s) {
  s.quality.keep_shadows = true;
  return s;
}

}  // namespace

std::vector<Variant> variants_of(const RenderSettings& common) {
  std::vector<Variant> all{
      {baseline_key, "baseline", "as published: every head, whole maps", every_head(common)},
      {skipping_key, "skipping",
       "the baseline without heads wholly outside the picture; all but the baselines leave them out",
       with(common, false, false, false)},
      {"cull", "cull", "skin that faces away is not lit", with(common, true, false, false)},
      {"depth", "depth", "maps as large as the distance needs", with(common, false, true, false)},
      {"clip", "clip", "skin outside the picture and a margin is not lit", with(common, false, false, true)},
      {optimised_key, "all", "cull, depth and clip", with(common, true, true, true), true},
  };

  if (common.quality.clip_margin_mm != 0.0)
    all.push_back({at_edge_key, "margin 0", "all, clipped at the edge of the picture as in the paper",
                   at_edge(common)});

  const RenderSettings computed = by("texture-space", with(common, true, true, true));
  all.push_back({compute_key, "compute", "all, by texture-space", computed, true});
  all.push_back({still_key, "still",
                 "compute, where heads and lights stand still: their shadow maps are kept", still(computed),
                 true});

  all.push_back({floor_key, "lambert", "the same lights and specular without scattering: the floor",
                 by("lambert", with(common, false, false, false))});
  return all;
}

}  // namespace dermis::cli::bench
