// SPDX-License-Identifier: MIT
// Pictures of a cell: how far the optimised one is from the baseline, and what the page shows.
#pragma once

#include <map>
#include <string>

#include "cli/bench/result.h"
#include "dermis/renderer.h"

namespace dermis::cli::bench {

/// Of each variant that is compared, by its key. Pictures are super-sampled, without bloom, from light maps
/// of the size that the picture at its own size has (d_ref). None without skin.
std::map<std::string, PictureDifference> picture_differences(Renderer& renderer, const Scene& scene,
                                                             const Cell& cell, double d_ref, int samples);

/// The part of both where either holds skin, with some room around it; reduced by a whole factor to at most
/// 960 pixels' width, or enlarged by one if it is tiny. The whole pictures if there is no skin.
CellPictures cut_to_skin(const Picture& baseline, const Picture& optimised);

/// The light map of the baseline, what the optimised frame makes of it, and the picture, for one head.
MapPictures map_pictures(Renderer& renderer, const Scene& scene, const RenderSettings& baseline,
                         const RenderSettings& optimised);

}  // namespace dermis::cli::bench
