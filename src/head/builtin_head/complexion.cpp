// SPDX-License-Identifier: MIT
// Based on:
// [A02] Alaluf, Atkins, Barrett et al.: Ethnic variation in melanin content and composition in photoexposed
// and photoprotected human skin. Pigment Cell Research 15, 2002 (colour of the exposed forearm) [X17] Xiao,
// Yates, Zardawi et al.: Characterising the variations in ethnic skin colours. Skin Research and Technology
// 23, 2017 (colour of forehead and cheek) [G09] Proposed shade guide for human facial skin and lip. IADR
// 2009; Journal of Prosthetic Dentistry 110, 2013 (clusters of noses and lips of 120 people)
#include "head/builtin_head/complexion.h"

#include "tissue/optics/skin_colour.h"

namespace dermis::builtin_head {

namespace {

const Colouring light_colours{.hair = {0.036f, 0.022f, 0.013f},
                              .iris_dark = {0.022f, 0.034f, 0.038f},
                              .iris_light = {0.150f, 0.190f, 0.180f},
                              .sclera = 1};
const Colouring medium_colours{.hair = {0.022f, 0.014f, 0.010f},
                               .iris_dark = {0.026f, 0.012f, 0.006f},
                               .iris_light = {0.150f, 0.075f, 0.028f},
                               .sclera = 0.94f};
const Colouring dark_colours{.hair = {0.012f, 0.009f, 0.008f},
                             .iris_dark = {0.012f, 0.006f, 0.004f},
                             .iris_light = {0.065f, 0.030f, 0.013f},
                             .sclera = 0.72f};

// optics::nearest_skin() of L*a*b* under D65; a test computes them again.
constexpr optics::Pigments pigments(double melanin, double haemoglobin) {
  return {.melanin = melanin, .haemoglobin = haemoglobin, .oxygenation = 0.75};
}
constexpr optics::Pigments light_lips{0.0354, 0.0914, 1};  // [G09] cluster 3: 49.4 22.0 12.3
constexpr optics::Pigments dark_lips{0.1137, 0.1, 1};      // [G09] cluster 2: 37.7 17.2 14.7

// In the order of Tone.
const std::array<Complexion, tone_names.size()> complexions{{
    {pigments(0.0245, 0.0137), light_lips, light_colours},  // [X17] Caucasian: 59.4 11.7 14.85
    {pigments(0.0613, 0.0135), dark_lips, medium_colours},  // [A02] Mexican: 50.42 12.69 19.58
    {pigments(0.1123, 0.0792), dark_lips, dark_colours},    // [A02] African: 38.14 12.66 15.04
    // [X17] Caucasian, inner arm, L* and b* a standard deviation lighter: 68.5 5.6 11.1
    {pigments(0.0086, 0.0051), light_lips, light_colours},
    {pigments(0.0147, 0.0066), light_lips, light_colours},   // [A02] European, upper arm: 65.0 7.1 13.3
    {pigments(0.0235, 0.0068), light_lips, medium_colours},  // [A02] Chinese, upper arm: 62.1 8.4 16.3
    {pigments(0.0337, 0.0143), dark_lips, medium_colours},   // [X17] Chinese, forehead: 56.4 11.7 16.3
    {pigments(0.0854, 0.0309), dark_lips, dark_colours},     // [A02] Indian, forearm: 43.71 12.89 17.15
    {pigments(0.1123, 0.0792), dark_lips, dark_colours},     // [A02] African, forearm: 38.14 12.66 15.04
}};

}  // namespace

const Complexion& complexion(Tone tone) { return complexions[static_cast<std::size_t>(tone)]; }

const optics::SkinTable& skin_table() {
  static const optics::SkinTable table(optics::measured_skin(), {0.25, 0.5, 0.75, 1});
  return table;
}

}  // namespace dermis::builtin_head
