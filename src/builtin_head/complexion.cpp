// SPDX-License-Identifier: MIT
// Based on:
// [A02] Alaluf, Atkins, Barrett et al.: Ethnic variation in melanin content and composition in photoexposed
// and photoprotected human skin. Pigment Cell Research 15, 2002 (colour of the exposed forearm) [X17] Xiao,
// Yates, Zardawi et al.: Characterising the variations in ethnic skin colours. Skin Research and Technology
// 23, 2017 (colour of forehead and cheek) [G09] Proposed shade guide for human facial skin and lip. IADR
// 2009; Journal of Prosthetic Dentistry 110, 2013 (clusters of noses and lips of 120 people)
#include "builtin_head/complexion.h"

#include "optics/skin_colour.h"

namespace dermis::builtin_head {

const Complexion& complexion(Tone tone) {
  // optics::nearest_skin() of L*a*b* under D65; a test computes them again.
  static const Complexion light{.skin = {.melanin = 0.0245,
                                         .haemoglobin = 0.0137,
                                         .oxygenation = 0.75},  // [X17] Caucasian: 59.4 11.7 14.85
                                .lips = {.melanin = 0.0354,
                                         .haemoglobin = 0.0914,
                                         .oxygenation = 1},  // [G09] cluster 3: 49.4 22.0 12.3
                                .colours = {.hair = {0.036f, 0.022f, 0.013f},
                                            .iris_dark = {0.022f, 0.034f, 0.038f},
                                            .iris_light = {0.150f, 0.190f, 0.180f},
                                            .sclera = 1}};
  static const Complexion medium{
      .skin = {.melanin = 0.0613,
               .haemoglobin = 0.0135,
               .oxygenation = 0.75},                                      // [A02] Mexican: 50.42 12.69 19.58
      .lips = {.melanin = 0.1137, .haemoglobin = 0.1, .oxygenation = 1},  // [G09] cluster 2: 37.7 17.2 14.7
      .colours = {.hair = {0.022f, 0.014f, 0.010f},
                  .iris_dark = {0.026f, 0.012f, 0.006f},
                  .iris_light = {0.150f, 0.075f, 0.028f},
                  .sclera = 0.94f}};
  static const Complexion dark{
      .skin = {.melanin = 0.1123,
               .haemoglobin = 0.0792,
               .oxygenation = 0.75},                                      // [A02] African: 38.14 12.66 15.04
      .lips = {.melanin = 0.1137, .haemoglobin = 0.1, .oxygenation = 1},  // [G09] cluster 2: 37.7 17.2 14.7
      .colours = {.hair = {0.012f, 0.009f, 0.008f},
                  .iris_dark = {0.012f, 0.006f, 0.004f},
                  .iris_light = {0.065f, 0.030f, 0.013f},
                  .sclera = 0.72f}};
  switch (tone) {
    case Tone::light: return light;
    case Tone::medium: return medium;
    case Tone::dark: break;
  }
  return dark;
}

const optics::SkinTable& skin_table() {
  static const optics::SkinTable table(optics::measured_skin(), {0.25, 0.5, 0.75, 1});
  return table;
}

}  // namespace dermis::builtin_head
