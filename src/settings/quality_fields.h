// SPDX-License-Identifier: MIT
// The settings of quality, a row for each. Part of fields.h.
#pragma once

#include <array>

#include "core/fields.h"
#include "dermis/settings.h"

namespace dermis {

template <>
inline constexpr auto fields_of<QualitySettings> = std::tuple{
    Field{"map_size",
          &QualitySettings::map_size,
          {.help = "side of the light maps",
           .unit = "texels",
           .least = 32,
           .most = 65536,
           .option = "map-size",
           .common = true,
           .rebuilds = true,
           .real_time = true}},
    Field{"shadow_size",
          &QualitySettings::shadow_size,
          {.help = "side of a shadow map",
           .unit = "texels",
           .least = 32,
           .most = 65536,
           .option = "shadow-size",
           .rebuilds = true,
           .real_time = true}},
    Field{"samples",
          &QualitySettings::samples,
          {.help = "anti-aliasing, 1 or 4 samples per pixel",
           .least = 1,
           .most = 4,
           .option = "samples",
           .rebuilds = true,
           .real_time = true}},

    Field{"cull",
          &QualitySettings::cull,
          {.help = "leave out skin that faces away",
           .option = "optimise",
           .rebuilds = true,
           .real_time = true}},
    Field{"depth",
          &QualitySettings::depth,
          {.help = "leave out map texels that the distance does not need",
           .option = "optimise",
           .rebuilds = true,
           .real_time = true}},
    Field{"clip",
          &QualitySettings::clip,
          {.help = "leave out skin outside the picture",
           .option = "optimise",
           .rebuilds = true,
           .real_time = true}},
    Field{"skip_unseen_heads",
          &QualitySettings::skip_unseen_heads,
          {.help = "leave out heads wholly outside the picture: true, false",
           .none = "true if anything is optimised",
           .option = "skip-unseen-heads",
           .real_time = true}},
    Field{"keep_shadows",
          &QualitySettings::keep_shadows,
          {.help = "shadow maps of heads and lights that have not moved are not drawn again: on, off",
           .option = "keep-shadows",
           .on = "on",
           .off = "off",
           .rebuilds = true,
           .real_time = true}},

    Field{"mask",
          &QualitySettings::mask,
          {.help = "how convolutions of published skip unlit texels",
           .none = "depth",
           .option = "mask",
           .rebuilds = true,
           .real_time = true}},

    Field{
        "shading",
        &QualitySettings::shading,
        {.help = "raster: skin is shaded where its triangles are drawn; compute: once per pixel and surface",
         .none = "fastest on this kind of device",
         .option = "shading",
         .rebuilds = true,
         .real_time = true}},

    Field{
        "blur",
        &QualitySettings::blur,
        {.help = "cascade: wide to narrow on a pyramid of maps, one map for the sum of the Gaussians; chain: "
                 "narrow to wide, a map of full size per Gaussian",
         .none = "cascade; chain where maps have too few texels for it",
         .option = "blur",
         .rebuilds = true,
         .real_time = true}},
    Field{
        "irradiance",
        &QualitySettings::irradiance,
        {.help = "how texels of light maps are lit: triangles are drawn, or a compute pass lights each texel",
         .none = "fastest on this kind of device",
         .option = "irradiance",
         .rebuilds = true,
         .real_time = true}},

    Field{"kernel",
          &QualitySettings::kernel,
          {.help = "of techniques in screen space: the profile of the skin, in mm; what the technique was "
                   "published with; or, of burley-disc, the profile as Unreal Engine weighs it",
           .option = "kernel",
           .rebuilds = true,
           .real_time = true}},
    Field{"blur_resolution",
          &QualitySettings::blur_resolution,
          {.help = "of techniques that blur in screen space: the picture's, or half its width and height",
           .option = "blur-resolution",
           .rebuilds = true,
           .real_time = true}},
    Field{"taps",
          &QualitySettings::taps,
          {.help =
               "of the kernels of techniques in screen space, no effect on others: screen-gaussians 5 to 13, "
               "odd; separable 3 to 33, odd; burley-disc 1 to 4096; pre-integrated, of its filter of "
               "shadows, 1 to 1024",
           .least = 1,
           .most = 4096,
           .none = "screen-gaussians 13, separable 25, burley-disc 64, pre-integrated 32",
           .option = "taps",
           .rebuilds = true,
           .real_time = true}},

    Field{"d_ref",
          &QualitySettings::d_ref,
          {.help = "distance up to which light maps have their full size",
           .unit = "radii",
           .least = 1e-6,
           .most = 1e6,
           .none = "where a texel is as large as a pixel",
           .option = "d-ref",
           .real_time = true}},
    Field{"clip_margin_mm",
          &QualitySettings::clip_margin_mm,
          {.help = "skin this far outside the picture is still lit",
           .unit = "mm",
           .least = 0,
           .most = 1e6,
           .none = "the profile's reach, 3 sigma of its widest Gaussian",
           .option = "clip-margin",
           .real_time = true}},
    Field{"map_budget_mb",
          &QualitySettings::map_budget_mb,
          {.help = "memory for light maps; skin that does not fit together goes in batches",
           .unit = "MB",
           .least = 0,
           .most = 1e9,
           .none = "four maps of full size, at most a quarter of the device's",
           .option = "map-budget",
           .rebuilds = true,
           .real_time = true}}};

template <>
inline constexpr std::array gone_from<QualitySettings>{
    Gone{"maps", {}, "quality.blur chooses the sizes of light maps, too"},
    Gone{"mask", "tiles",
         "texture-space always blurs tiles, and published has no other masks than alpha and depth"}};

}  // namespace dermis
