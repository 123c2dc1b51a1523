// SPDX-License-Identifier: MIT
// The published speed-ups: [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin. CEIG 2008.
#pragma once

#include <array>
#include <optional>

namespace dermis::cli::bench {

inline constexpr std::array paper_heads{1, 2, 4, 8, 16};
/// eye to the middle head, sphere radii
inline constexpr std::array paper_distances{2.5, 5.0, 10.0, 20.0, 50.0, 100.0};

/// [JG08] table 1: a frame without over a frame with all three optimisations, GeForce 8800 GTX, 1920 x 1200
/// pixels, six maps of 2048 texels, shadow maps alike. None where the paper has no such cell.
std::optional<double> paper_speedup(int heads, double distance);

}  // namespace dermis::cli::bench
