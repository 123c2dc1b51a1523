// SPDX-License-Identifier: MIT
// Where the triangle of an entry is seen, and its skin there. Needs listed_entry.glsl, and what
// skin_answer.glsl declares.
#include "render/shaders/bulge.glsl"
layout(constant_id = 16) const bool multisampled = true;
layout(constant_id = 23) const int light_samples = 2;  // of a pixel that one surface covers

// Where a pixel sees a triangle: barycentric coordinates, which sum to 1, and their change per pixel.
struct Seen {
  vec3 share, dx, dy;
  vec3 near;    // as share, but up to a quarter of a height outside the triangle
  vec3 beside;  // as share, on its plane: below 0 where the point lies beside the triangle
  bool front;   // its corners turn counter-clockwise
};

// Returns whether there is an entry of the part for this invocation.
bool find_entry(out Entry entry) {
  uint place;
  if (!find_listed(place)) return false;
  zero = list[place] >> 31;  // never set: render/shared/entries_io.h
  entry = listed(list[place]);
  return true;
}

// Returns the mean of some samples of a pixel, in pixels; the middle if they are all. Positions are the
// standard ones of Vulkan.
vec2 middle_of(uint samples) {
  if (samples == 15u || !multisampled) return vec2(0.5);
  const vec2 sum = ((samples & 1u) != 0u ? vec2(0.375, 0.125) : vec2(0.0)) +
                   ((samples & 2u) != 0u ? vec2(0.875, 0.375) : vec2(0.0)) +
                   ((samples & 4u) != 0u ? vec2(0.125, 0.625) : vec2(0.0)) +
                   ((samples & 8u) != 0u ? vec2(0.625, 0.875) : vec2(0.0));
  return sum / float(bitCount(samples));
}

// The middle of the pixel was tested of skin that is cut, also beside the triangle. Maps have a gap anywhere
// else, and the colour of what is not there.
bool is_cut_out() { return is_on(material.flags & MATERIAL_ALPHA_MASK); }

// Returns whether an entry is lit at two points.
bool has_two_points(Entry entry) {
  return light_samples == 2 && is_whole(entry, multisampled) && !is_cut_out();
}

// Returns a point of an entry, in pixels. Two lie on a diagonal: at the first and the last sample, if there
// are several.
vec2 point_of(Entry entry, int point) {
  if (is_cut_out()) return vec2(0.5);
  if (!has_two_points(entry)) return middle_of(entry.samples);
  if (!multisampled) return vec2(0.25 + 0.5 * float(point));
  return point == 0 ? vec2(0.375, 0.125) : vec2(0.625, 0.875);
}

// The corners of a triangle in clip coordinates are a, b, c. The point on the ray through `at` is sum share_i
// corner_i with sum share_i (x_i - at.x w_i) = 0, and y likewise: the shares are the cross product of both
// rows. Relative to the ray, small triangles far away lose no digits.
Seen seen_at(vec2 at, vec4 a, vec4 b, vec4 c) {
  const vec3 w = vec3(a.w, b.w, c.w);
  const vec3 x = vec3(a.x, b.x, c.x) - at.x * w, y = vec3(a.y, b.y, c.y) - at.y * w;
  const vec3 area = cross(x, y), by_x = cross(y, w), by_y = cross(w, x);
  const float whole = area.x + area.y + area.z;
  if (!(abs(whole) > 0.0))
    return Seen(vec3(1.0 / 3.0), vec3(0.0), vec3(0.0), vec3(1.0 / 3.0), vec3(1.0 / 3.0), true);

  Seen seen;
  seen.front = whole > 0.0;
  seen.beside = area / whole;
  const vec2 step = 2.0 / vec2(frame.picture_size);
  seen.dx = (by_x - seen.beside * (by_x.x + by_x.y + by_x.z)) * (step.x / whole);
  seen.dy = (by_y - seen.beside * (by_y.x + by_y.y + by_y.z)) * (step.y / whole);

  // The point may lie beside its triangle, whose edge is within the pixel. A little outside, a smooth surface
  // goes on as the triangle does, and the middle of the pixel is what it shows; further, rims would sparkle.
  seen.share = max(seen.beside, vec3(0.0));
  seen.share /= seen.share.x + seen.share.y + seen.share.z;
  seen.near = max(seen.beside, vec3(-0.25));
  seen.near /= seen.near.x + seen.near.y + seen.near.z;
  return seen;
}

vec2 at_seen(vec3 share, vec2 a, vec2 b, vec2 c) { return share.x * a + share.y * b + share.z * c; }
vec3 at_seen(vec3 share, vec3 a, vec3 b, vec3 c) { return share.x * a + share.y * b + share.z * c; }
vec4 at_seen(vec3 share, vec4 a, vec4 b, vec4 c) { return share.x * a + share.y * b + share.z * c; }

// The raster has tested the middle of the pixel against gaps, with corners in 1/256 of a pixel: here it may
// lie across the edge. Returns coordinates of the nearest point that is there, their change per pixel is dx,
// dy.
vec4 beside_gap(vec4 uv, vec4 colour, vec4 dx, vec4 dy) {
  const float way = 1.0 / 32.0;
  if (!is_cut(uv, colour)) return uv;
  if (!is_cut(uv + way * dx, colour)) return uv + way * dx;
  if (!is_cut(uv - way * dx, colour)) return uv - way * dx;
  if (!is_cut(uv + way * dy, colour)) return uv + way * dy;
  if (!is_cut(uv - way * dy, colour)) return uv - way * dy;
  return uv;
}

// The surface of an entry.
struct SeenSkin {
  ShadingPoint s;
  OnMap on;
  uvec3 corners;  // vertices of the triangle
  vec3 share;     // of each
};

// point: 0, or 1 where there are two.
SeenSkin seen_skin(Entry entry, int point) {
  const bool second = point == 1 && has_two_points(entry);
  const uint first = 3u * (io.first_triangle + (second ? entry.second_triangle : entry.triangle));
  const uint i = indices[first], j = indices[first + 1u], k = indices[first + 2u];
  const VertexIo a = vertex_at(i), b = vertex_at(j), c = vertex_at(k);
  const vec3 pa = world_position(a.position_m), pb = world_position(b.position_m),
             pc = world_position(c.position_m);

  const bool cut = is_cut_out();
  const vec2 at = vec2(entry.at.xy - ivec2(frame.picture_low)) + point_of(entry, point);
  const Seen seen = seen_at((2.0 * at / vec2(frame.picture_size) - 1.0) * vec2(1.0, -1.0), clip_position(pa),
                            clip_position(pb), clip_position(pc));

  const VertexExtraIo ea = vertex_extra(i), eb = vertex_extra(j), ec = vertex_extra(k);
  const vec4 uva = vec4(a.uv0, ea.uv1), uvb = vec4(b.uv0, eb.uv1), uvc = vec4(c.uv0, ec.uv1);
  // Each of two points stands for half of the pixel, and shows finer maps.
  const float footprint = has_two_points(entry) ? 0.5 : 1.0;
  const vec4 dx = footprint * at_seen(seen.dx, uva, uvb, uvc),
             dy = footprint * at_seen(seen.dy, uva, uvb, uvc);
  const vec4 colour = at_seen(seen.share, ea.colour, eb.colour, ec.colour);
  vec4 uv = at_seen(cut ? seen.beside : seen.near, uva, uvb, uvc);
  if (cut) uv = beside_gap(uv, colour, dx, dy);

  const float side = seen.front ? 1.0 : -1.0;
  const vec3 position_m = at_seen(seen.near, pa, pb, pc);
  // Beside a triangle its plane lies above skin that bends away, but in a fold below it, in shadow.
  const vec3 beyond_m = at_seen(seen.near - seen.share, a.position_m, b.position_m, c.position_m);
  const float above_m = side * dot(beyond_m, at_seen(seen.share, a.normal, b.normal, c.normal));
  const vec3 shadow_share = above_m > 1e-3 * length(beyond_m) ? seen.near : seen.share;
  const float plane =
      dot(shadow_share, vec3(plane_distance(a.position_m, a.normal), plane_distance(b.position_m, b.normal),
                             plane_distance(c.position_m, c.normal)));
  const float bulge = bulge_at(at_seen(shadow_share, a.position_m, b.position_m, c.position_m),
                               at_seen(shadow_share, a.normal, b.normal, c.normal), plane);
  const vec3 normal = at_seen(seen.near, a.normal, b.normal, c.normal);
  const vec4 tangent = at_seen(seen.near, a.tangent, b.tangent, c.tangent);
  const ShadingPoint s =
      ShadingPoint(position_m, at_seen(shadow_share, pa, pb, pc), side * normalize(world_direction(normal)),
                   side * WORLD_FROM_ASSET.scale * bulge, vec4(world_direction(tangent.xyz), tangent.w),
                   uv.xy, uv.zw, colour, dx, dy);

  const SkinVertexIo sa = skin_vertex_at(i), sb = skin_vertex_at(j), sc = skin_vertex_at(k);
  OnMap on = OnMap(at_seen(seen.share, sa.unwrap, sb.unwrap, sc.unwrap), 1.0, vec4(0.0),
                   AlongSkin(vec3(0.0), vec3(0.0)));
  // Maps hold light of the front: the back of double-sided skin is lit at the pixel, as without texels.
  if (mixed)
    on.uv_per_mm = seen.front ? dot(seen.share, vec3(uv_per_mm(sa.metric_mm2), uv_per_mm(sb.metric_mm2),
                                                     uv_per_mm(sc.metric_mm2)))
                              : 0.0;
  if (shape_aware) {
    on.shape = at_seen(seen.share, body_shape(sa), body_shape(sb), body_shape(sc));
    on.along = along_triangle(pa, pb, pc, sa.unwrap, sb.unwrap, sc.unwrap);
  }
  return SeenSkin(s, on, uvec3(i, j, k), seen.share);
}
