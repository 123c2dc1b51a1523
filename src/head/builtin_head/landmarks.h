// SPDX-License-Identifier: MIT
// Curves that sculptor and painter share, on the left half of the symmetric face. Millimetres.
#pragma once

#include <vector>

#include "head/builtin_head/clay.h"

namespace dermis::builtin_head {

// Edges of the open lids, from the inner to the outer corner.
inline const std::vector<vec3> upper_lid = {{16.4f, -3.2f, 74}, {19, -0.5f, 76},   {23, 2.4f, 79},
                                            {27.5f, 4.0f, 81},  {32, 4.2f, 81},    {37, 3.2f, 79},
                                            {42, 1.3f, 75},     {46.6f, -1.2f, 69}};
inline const std::vector<vec3> lower_lid = {{16.4f, -3.2f, 74}, {19.5f, -4.4f, 76}, {24, -5.5f, 79},
                                            {29, -6.0f, 80},    {34, -6.0f, 80},    {39, -5.1f, 77},
                                            {43.5f, -3.2f, 73}, {46.6f, -1.2f, 69}};
// Fold over the upper lid, and hollow under the lower one.
inline const std::vector<vec3> upper_crease = {{15.5f, -0.2f, 75}, {19, 3.6f, 77}, {24, 6.7f, 79},
                                               {30, 8.1f, 80},     {36, 7.5f, 78}, {42, 5.1f, 75},
                                               {47, 1.8f, 70},     {51, -1.8f, 66}};
inline const std::vector<vec3> lower_crease = {{17, -8.5f, 75},  {22, -12.4f, 76}, {29, -14.8f, 77},
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
inline const std::vector<vec3> brow_line = {{13, 15.2f, 95}, {19, 17.4f, 94}, {27, 19.4f, 92},
                                            {36, 20.4f, 88}, {44, 18.8f, 82}, {52, 14.2f, 73}};

}  // namespace dermis::builtin_head
