// SPDX-License-Identifier: MIT
// Measured colours of skin: mean L*, a*, b* under D65.
//
// Alaluf et al.: The impact of epidermal melanin on objective measurements of human skin colour. Pigment Cell
// Research, 2002 (10-degree observer)
// Xiao et al.: Characterising the variations in ethnic skin colours: a new calibrated data base for human
// skin. SpectralSkin Research and Technology, 2017
#pragma once

#include "tissue/optics/observer.h"

namespace dermis {

struct MeasuredSkin {
  const char* name;
  optics::Lab lab;
};

inline constexpr MeasuredSkin measured_skins[] = {
    {"European, upper arm", {65.0, 7.1, 13.3}},     {"Chinese, upper arm", {62.1, 8.4, 16.3}},
    {"Mexican, upper arm", {61.9, 8.3, 15.3}},      {"Indian, upper arm", {53.7, 10.3, 17.9}},
    {"African, upper arm", {49.2, 10.2, 18.4}},     {"European, forearm", {53.94, 12.57, 19.23}},
    {"Chinese, forearm", {51.38, 12.69, 19.18}},    {"Mexican, forearm", {50.42, 12.69, 19.58}},
    {"Indian, forearm", {43.71, 12.89, 17.15}},     {"African, forearm", {38.14, 12.66, 15.04}},
    {"Caucasian, forehead", {59.2, 11.6, 15.1}},    {"Caucasian, cheek", {59.6, 11.8, 14.6}},
    {"Caucasian, back of hand", {60.1, 7.4, 14.7}}, {"Caucasian, inner arm", {63.0, 5.6, 14.0}},
    {"Chinese, forehead", {56.4, 11.7, 16.3}},      {"Chinese, cheek", {58.9, 11.4, 14.2}},
    {"Chinese, back of hand", {57.9, 9.3, 16.1}},   {"Chinese, inner arm", {60.9, 7.0, 15.0}},
    {"Kurdish, forehead", {56.1, 11.3, 16.4}},      {"Kurdish, cheek", {58.0, 11.7, 15.8}},
    {"Kurdish, back of hand", {57.3, 8.6, 16.5}},   {"Kurdish, inner arm", {60.6, 6.5, 16.4}},
    {"Thai, forehead", {56.8, 11.6, 17.7}},         {"Thai, cheek", {60.7, 10.5, 17.2}},
    {"Thai, back of hand", {57.6, 9.4, 19.0}},      {"Thai, inner arm", {61.9, 7.1, 17.4}},
};

}  // namespace dermis
