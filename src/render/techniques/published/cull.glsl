// SPDX-License-Identifier: MIT
// [JG08] sec. 3: skin whose normal is more than 105 degrees from the direction to the eye is not lit. Needs
// vertex_pull.glsl, skin_vertex.glsl, head.glsl, frame.glsl and `indices`.
//
// Departures. Listings 1 and 2 decide per texel, by the interpolated normal. On a coarse mesh that culls
// texels that are seen (119 in one view of a head of few polygons), as the paper warns. Here whole triangles
// are culled: all their vertex normals are over 105 degrees, and the triangle faces away. The direction is
// the true one of each vertex; the listing has the axis of the view for all.
layout(binding = 28, scalar) readonly buffer TurnedNeighbours {
  uint turned_neighbours[];
};                                            // head/scene/surface/turned.h
const float cos_105_degrees = -0.2588190451;  // listing 2
const uint always_kept = 0xFFFFFFFFu;         // as in head/scene/surface/turned.h

bool faces_away(uint first) {
  const vec3 p = vertex_position(indices[first]);
  const vec3 ab = vertex_position(indices[first + 1]) - p, ac = vertex_position(indices[first + 2]) - p;
  return dot(world_direction(cross(ab, ac)), to_eye(world_position(p))) < 0.0;
}

// Returns whether a triangle is so thin on a map of this side that it may contain no texel centre: an
// inscribed circle whose radius is under 0.75 texels.
bool falls_between_texels(uint first, float side) {
  const vec2 a = unwrap_of(indices[first]), b = unwrap_of(indices[first + 1]),
             c = unwrap_of(indices[first + 2]);
  const vec2 ab = b - a, ac = c - a;
  return abs(ab.x * ac.y - ab.y * ac.x) * side < 0.75 * (length(ab) + length(ac) + length(c - b));
}

bool triangle_culled(uint triangle, float side) {
  bool away = faces_away(3u * triangle);
  for (uint i = 0u; i < 3u; ++i) {
    const VertexIo v = vertex_at(indices[3u * triangle + i]);
    const vec3 eye = to_eye(world_position(v.position_m));
    away = away && dot(world_direction(v.normal), eye) < cos_105_degrees * length(eye) * length(v.normal);
  }
  // A visible triangle without a texel reads the light of its neighbours.
  if (away)
    for (uint k = turned_neighbours[triangle]; k < turned_neighbours[triangle + 1u]; ++k) {
      if (turned_neighbours[k] == always_kept) return false;
      const uint first = 3u * turned_neighbours[k];
      if (falls_between_texels(first, side) && !faces_away(first)) return false;
    }
  return away;
}
