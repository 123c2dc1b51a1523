// SPDX-License-Identifier: MIT
// Curves that sculptor and painter share, on the left half of the symmetric face. Millimetres.
#pragma once

#include <vector>

#include "builtin_head/clay.h"

namespace dermis::builtin_head {

// The line on which the lids meet: from the inner to the outer corner, lowest beyond its middle.
inline const std::vector<vec3> lash_line = {{16.2f, -3.4f, 74}, {20.5f, -5.6f, 77}, {26, -7.4f, 80},
                                            {32.5f, -8.0f, 80}, {39, -6.6f, 77},    {44.5f, -3.8f, 73},
                                            {48.2f, -1.4f, 69}};
inline const std::vector<vec3> upper_crease = {{16, 0.5f, 75}, {20, 4.6f, 77}, {26, 7.4f, 78}, {33, 8.2f, 78},
                                               {40, 6.6f, 75}, {46, 2.6f, 71}, {51, -2.2f, 66}};
inline const std::vector<vec3> lower_crease = {{17, -8.0f, 75},  {22, -12.0f, 76}, {29, -14.6f, 77},
                                               {36, -14.4f, 77}, {42, -11.6f, 75}, {47, -7.5f, 71}};
inline const std::vector<vec3> tear_trough = {
    {14.5f, -5.5f, 76}, {18, -13, 77}, {24, -19, 78}, {32, -23, 79}};

inline const std::vector<vec3> mouth_line = {{0, -68.6f, 98},  {4, -67.9f, 98},  {9, -67.6f, 97},
                                             {15, -68.5f, 94}, {21, -69.2f, 89}, {26, -69.8f, 84}};
inline const std::vector<vec3> upper_border = {{0, -61.6f, 101}, {3, -60.4f, 101}, {5.5f, -60.0f, 101},
                                               {10, -61.6f, 99}, {16, -64.4f, 95}, {22, -67.6f, 89},
                                               {26, -69.8f, 84}};
inline const std::vector<vec3> lower_border = {
    {0, -78.6f, 98}, {6, -78.4f, 98}, {12, -77.0f, 96}, {18, -74.4f, 92}, {24, -71.4f, 87}};
// Middle of the eyebrow, from the nose outwards.
inline const std::vector<vec3> brow_line = {{11, 16.5f, 95}, {18, 19.0f, 94}, {27, 21.4f, 92},
                                            {36, 22.4f, 88}, {44, 20.6f, 82}, {52, 15.5f, 73}};

}  // namespace dermis::builtin_head
