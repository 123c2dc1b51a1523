// SPDX-License-Identifier: MIT
// Index buffers of draws whose shaders must know the triangle that they draw.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace dermis::passes {

/// Returns three indices per triangle, in the order of `indices` (a list of triangles over `vertices`
/// vertices): t for the first corner of triangle t, which is also the provoking one. Any other corner has the
/// number of an earlier triangle with the same vertex as first corner, the latest that was drawn, so that the
/// device finds it shaded; or the number of its vertex plus the number of triangles.
///
/// Unlike the number of the primitive in fragment shaders this needs no optional feature of Vulkan.
std::vector<std::uint32_t> first_corner_indices(std::span<const std::uint32_t> indices, std::size_t vertices);

}  // namespace dermis::passes
