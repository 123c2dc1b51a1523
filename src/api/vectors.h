// SPDX-License-Identifier: MIT
// The public interface's arrays as vectors, and back.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace dermis::api {

inline glm::dvec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
inline std::array<double, 3> array_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace dermis::api
