// SPDX-License-Identifier: MIT
// Rows of what a comparison of techniques with ground truth can be told.
#pragma once

#include "base/core/fields.h"
#include "dermis/compare.h"

namespace dermis {

template <>
inline constexpr auto fields_of<SceneComparisonSettings> = std::tuple{
    Field{"techniques",
          &SceneComparisonSettings::techniques,
          {.help = "names of techniques", .option = "techniques"}},
    Field{"each_optimisation",
          &SceneComparisonSettings::each_optimisation,
          {.help = "further rows: nothing optimised, cull, depth and clip by themselves, and all of them",
           .option = "each-optimisation"}},
    Field{
        "supersample",
        &SceneComparisonSettings::supersample,
        {.help = "errors are of pictures this many times as wide and as high, averaged; times stay those of "
                 "the picture",
         .least = 1,
         .most = 16,
         .option = "supersample"}},
    Field{
        "curves",
        &SceneComparisonSettings::curves,
        {.help =
             "further frames of each technique with its own quality settings (taps, kernels, maps): a curve "
             "of error over cost",
         .option = "curves"}}};

}  // namespace dermis
