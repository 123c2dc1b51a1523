// SPDX-License-Identifier: MIT
// Parts of the head beside its skin: eyes with tears and caruncles, teeth, gums
// and tongue, brows and lashes.
#pragma once

#include "head/builtin_head/complexion.h"
#include "head/builtin_head/sculpture.h"
#include "head/scene/asset_data.h"
#include "image/image.h"

namespace dermis::builtin_head {

/// Returns metres in the scene, with the line of the eyes 35 mm above the origin, for the sculptor's mm.
inline vec3 to_world_m(const vec3& p_mm) {
  return 0.001f * vec3(p_mm.x, p_mm.y + Sculpture::eyes_over_origin_mm, p_mm.z);
}

/// Adds a map that says which share of their surroundings parts see, everywhere the same, 0..1. Returns its
/// number.
int add_openness(scene::AssetData& scene, const char* name, float share);

/// Builds a primitive of a part from points of the symmetric face.
class PartMesh {
 public:
  PartMesh(const char* name, int material);
  /// Adds a corner; `normal` need not be unit. Returns its number.
  std::uint32_t add(const vec3& symmetric_mm, const vec3& normal, const vec2& uv);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  /// Adds the cells of a grid of `columns` x `rows` corners that starts at `first`, row by row; counter-
  /// clockwise seen from where columns grow to the right and rows upwards, or turned.
  void grid(std::uint32_t first, int columns, int rows, bool turned);
  /// Returns the primitive, with tangents.
  scene::Primitive finish();

 private:
  scene::Primitive mesh_;
};

/// Returns how far the surface of the eyeball is from its centre in direction `d` (unit, +z to the pupil),
/// mm: a sphere with the cornea's cap.
float eye_radius_mm(const vec3& d);

/// Adds both eyeballs, the rim of tears along the lower lids and the caruncles, with their materials and map.
void add_eyes(const Sculpture& bust, scene::AssetData& scene, const Colouring& colours, int map_size);

/// Adds teeth, gums and the tongue, behind the lips.
void add_teeth(scene::AssetData& scene);

/// Adds brows and lashes: blended cards with one map.
void add_hair_cards(const Sculpture& bust, scene::AssetData& scene, const Colouring& colours, int map_size);

}  // namespace dermis::builtin_head
