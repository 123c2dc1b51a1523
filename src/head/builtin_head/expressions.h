// SPDX-License-Identifier: MIT
// Movements of the face: displacements of points of the symmetric face, mm.
#pragma once

#include <array>

#include "head/builtin_head/sculpture.h"

namespace dermis::builtin_head {

enum class Expression { blink_left, blink_right, jaw_open, smile, brows_up, pucker };
constexpr std::array<const char*, 6> expression_names = {"blink left", "blink right", "jaw open",
                                                         "smile",      "brows up",    "pucker"};

/// Where the joint of the jaw turns, and by how much `jaw open` turns it.
inline const vec3 jaw_joint(0, -24, 6);
inline constexpr float jaw_open_rad = 0.24f;

/// Properties of a point beside its place.
struct Attachment {
  /// Row of a node in the mouth's pouch, from the seam: above 0 the upper lip's, below 0 the lower one's; 0:
  /// elsewhere, or the throat.
  int lip = 0;
  /// Row of a node in the pouch between the lids, likewise.
  int lid = 0;
};

/// Returns the share of the jaw in the movement of a point, 0..1.
float jaw_share(const vec3& q, const Attachment& at);
/// Returns by how much a point moves at weight 1.
vec3 displacement(Expression expression, const vec3& q, const Attachment& at);
/// Returns the turn of the upper lid about the eye's x axis, rad, which closes the eye at x (mm from the
/// midline; positive).
float blink_turn(float x);

}  // namespace dermis::builtin_head
