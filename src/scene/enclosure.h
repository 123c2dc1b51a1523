// SPDX-License-Identifier: MIT
// Encloses a shape in a convex body of few corners, for fits that are tighter than a sphere.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace dermis::scene {

/// Returns the corners of the smallest body with faces in 50 fixed directions that holds all points, enlarged
/// by 1e-5 of its size against rounding. At most 96 or so; none if there is no point. Flat shapes have flat
/// bodies.
std::vector<glm::vec3> enclosing_corners(std::span<const glm::vec3> points_m);

/// Returns the enclosing_corners of all vertices of the primitives, in all their placements.
std::vector<glm::vec3> enclosing_corners(const Scene& scene);

/// How far points reach along each of the 50 directions, m.
using Reach = std::array<double, 50>;
Reach reach_of(std::span<const glm::vec3> points_m);

/// Returns the least factor by which a body of enclosing_corners() that reaches `body` must grow about
/// `centre_m`, a point within it, to hold points that reach `points`; infinite for a flat body that they
/// leave.
double growth_to_hold(const Reach& body, const Reach& points, const glm::dvec3& centre_m);

/// Returns the reach of the same points, moved.
Reach moved(const Reach& reach, const glm::dvec3& by_m);

}  // namespace dermis::scene
