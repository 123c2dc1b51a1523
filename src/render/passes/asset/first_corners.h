// SPDX-License-Identifier: MIT
// Index buffers of draws whose shaders must know the triangle that they draw.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace dermis::passes {

/// Returns three indices per triangle of `indices`. Its number t stands for the first corner, which is also
/// the provoking one. The others have the number of triangles plus that of the vertex.
///
/// A device shades 1.9 vertices per triangle of the scan (it remembers the last 16), and 0.9 with `indices`.
/// To turn triangles so that their first corner is a vertex not yet drawn would need 1.2, but rounds
/// otherwise where depth must be equal to the bit. To take an earlier first corner of the same vertex gains
/// nothing. Unlike the number of the primitive in fragment shaders this needs no optional feature of Vulkan.
std::vector<std::uint32_t> first_corner_indices(std::span<const std::uint32_t> indices);

}  // namespace dermis::passes
