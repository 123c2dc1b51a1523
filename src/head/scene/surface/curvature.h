// SPDX-License-Identifier: MIT
// Curvature of skin at its vertices, at the scale that light spreads over.
// Based on:
// [R04] Rusinkiewicz: Estimating Curvatures and Their Derivatives on Triangle Meshes. 3DPVT 2004 (the second
//       fundamental form as the best linear change of normals); here over a Gaussian neighbourhood
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Both principal curvatures k1 >= k2 as their mean and half of their difference. Convex is positive: a
/// sphere of radius R mm has mean 1/R and difference 0, a cylinder 1/2R and 1/2R, a saddle mean 0.
struct Curvature {
  float mean_per_mm = 0;        ///< (k1 + k2) / 2
  float difference_per_mm = 0;  ///< (k1 - k2) / 2, >= 0
};

/// Shape of the body around a vertex of skin, in mm of the asset.
struct VertexShape {
  Curvature curvature;
  float thickness_mm = 0;  ///< of a slab its thickness; environment/body_shape.h finds it
  float border_mm = 0;     ///< to the nearest open border: head/scene/surface/open_border.h
};

/// A neighbour that counts for the curvature of a vertex.
struct CurvatureNeighbour {
  std::uint32_t vertex = 0;
  float weight = 0;  ///< its area, times a Gaussian of its distance; those of a vertex sum to 1
};

/// Neighbours that count for each vertex: those of vertex v are [first[v], first[v + 1]) of `neighbours`. It
/// holds for the mesh in every pose: a neighbourhood moves with its skin.
struct CurvatureStencil {
  std::vector<std::uint32_t> first;  ///< as many as vertices, and one
  std::vector<CurvatureNeighbour> neighbours;
};

inline constexpr std::size_t most_curvature_neighbours = 32;

/// The curvature is the mean of what two Gaussian neighbourhoods see, of these standard deviations, > 0.
/// Light spreads likewise: most of it stays near, some goes far.
struct CurvatureScales {
  double narrow_mm = 0, wide_mm = 0;
};

/// Finds the neighbours of each vertex: those that edges reach within 2.5 wide scales, so that lips that
/// touch do not count for each other. They are at least those at the other end of its edges; of many, a
/// selection in proportion to their weights. Vertices at one place (at seams) have the same. indices.size()
/// is a multiple of 3, all < vertices.size(). O(n); the result does not depend on the number of threads.
/// Throws Cancelled if a hook ends it.
CurvatureStencil curvature_stencil(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                                   double mm_per_unit, const CurvatureScales& scales);

/// Returns the curvature at each vertex, 0 where a vertex has fewer than three neighbours or they lie on a
/// line. At most 2 per mm: a rim may be sharp. `vertices` may have moved since the stencil was made.
std::vector<Curvature> curvatures(std::span<const Vertex> vertices, const CurvatureStencil& stencil,
                                  double mm_per_unit);

}  // namespace dermis::scene
