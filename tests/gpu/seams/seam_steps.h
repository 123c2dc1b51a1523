// SPDX-License-Identifier: MIT
// How far the displayed light steps across the seams of an unwrap, beside how far it steps next to them.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "dermis/renderer.h"
#include "dermis/scene.h"

namespace dermis::tests {

/// Neighbouring pixels between which the unwrap is cut, and one more pixel to either side: four in a row.
struct Crossing {
  glm::ivec2 first{0};
  glm::ivec2 step{0};   ///< from each to the next
  std::size_t run = 0;  ///< crossings of one run lie on one piece of one seam
};

struct Crossings {
  std::vector<Crossing> all;
  std::size_t runs = 0;
  /// left out: an edge of a shadow goes through, or the file's normals turn more than beside the seam
  std::size_t in_shadow_edges = 0, creased = 0;
};

/// Of what `settings` show of the skin, under the first light. The middle of a pixel decides what it shows,
/// so pictures are compared at one sample per pixel. InputError: as for render_reference.
Crossings find_crossings(const Scene& scene, const RenderSettings& settings);

/// Of a run of at least `least` crossings: by how much the mean step across exceeds the mean steps beside it,
/// and what `unmapped` steps there: the same light without light maps, which steps at folds of the mesh too.
struct Excess {
  double largest = -255;  ///< display values, of 255; the worst run and channel
  std::size_t runs = 0;   ///< that were long enough
  glm::ivec2 pixel{0};    ///< a crossing of the worst run
};
Excess seam_excess(const Crossings& crossings, const Picture& picture, const Picture& unmapped,
                   std::size_t least = 12);

/// What a head of one chart, cut where u is 0 and 1, would show if skin of u over 1/2 read its light `texels`
/// nearer to the middle of the chart than it lies: pixels of that half show what the nearest pixel of those
/// texture coordinates shows, at most six pixels off.
Picture read_off(const Scene& scene, const RenderSettings& settings, const Picture& picture, double texels);

}  // namespace dermis::tests
