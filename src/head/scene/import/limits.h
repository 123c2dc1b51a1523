// SPDX-License-Identifier: MIT
// Limits of a scene, whether a file or a host gives it.
#pragma once

#include <cstddef>

namespace dermis::scene {

/// Far beyond any head; keeps squares and sums of float positions finite.
inline constexpr double largest_position_m = 1e6;
inline constexpr float largest_uv = 1e5f;             ///< more repeats of a map than any picture shows
inline constexpr std::size_t most_skin_nodes = 1024;  ///< half a minute per frame on a software driver

inline constexpr float largest_radiance = 1e6f;  ///< beyond any half float
inline constexpr float largest_ior = 100;        ///< 0 stands for it: Fresnel of 1 everywhere
inline constexpr float largest_cutoff = 1e6f;    ///< of the alpha test
inline constexpr float largest_map_factor = 1000;
inline constexpr float largest_displacement_mm = 100;
inline constexpr float largest_detail_scale = 10;

inline constexpr std::size_t most_lobes = 2;
inline constexpr double largest_lobe_factor = 100;     ///< on m
inline constexpr double lobe_weight_tolerance = 1e-3;  ///< of their sum, which is 1

}  // namespace dermis::scene
