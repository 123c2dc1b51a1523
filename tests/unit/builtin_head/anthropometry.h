// SPDX-License-Identifier: MIT
// Published measures of adult men that the built-in head is held to: each within one standard deviation.
//
// [ZB05] Zhuang, Bradtmiller: Head-and-Face Anthropometric Survey of U.S. Respirator Users. Journal of
//        Occupational and Environmental Hygiene 2 (2005), 567-576, men (2,543).
// [F94]  Farkas (ed.): Anthropometry of the Head and Face, 2nd ed., Raven Press 1994, appendix A: North
//        American white men of 19 to 25 years.
#pragma once

namespace dermis::builtin_head::anthropometry {

struct Measure {
  const char* name;
  double mean_mm, deviation_mm;
};

inline constexpr Measure head_breadth{"head breadth [ZB05]", 153.0, 6.0};
inline constexpr Measure head_length{"head length [ZB05]", 197.3, 7.4};
inline constexpr Measure bizygomatic_breadth{"bizygomatic breadth [ZB05]", 143.5, 6.9};
inline constexpr Measure bigonial_breadth{"bigonial breadth [ZB05]", 120.4, 10.4};
inline constexpr Measure menton_sellion{"menton to sellion [ZB05]", 122.7, 7.0};
inline constexpr Measure subnasale_sellion{"subnasale to sellion [ZB05]", 52.0, 4.1};
inline constexpr Measure nose_breadth{"nose breadth [ZB05]", 36.6, 4.1};
inline constexpr Measure nose_protrusion{"nose protrusion [ZB05]", 21.1, 2.7};
inline constexpr Measure lip_length{"lip length [ZB05]", 51.1, 4.2};
inline constexpr Measure interpupillary_distance{"interpupillary distance [ZB05]", 64.5, 3.6};
inline constexpr Measure intercanthal_width{"intercanthal width, en-en [F94]", 33.3, 2.7};
inline constexpr Measure biocular_width{"biocular width, ex-ex [F94]", 91.2, 3.0};
inline constexpr Measure eye_fissure_length{"eye fissure length, en-ex [F94]", 31.3, 1.2};
inline constexpr Measure eye_fissure_height{"eye fissure height, ps-pi [F94]", 10.8, 1.2};
inline constexpr Measure ear_length{"length of the auricle, sa-sba [F94]", 62.7, 3.6};

}  // namespace dermis::builtin_head::anthropometry
