// SPDX-License-Identifier: MIT
// What a texel of a light map shows, for compute passes over the texels of a square: the triangle that the
// map of texels names (passes/texel_map), and its vertices' values at the centre of the texel. Needs
// scene_io.h; COMPUTE_SHADING is defined.
#include "passes/irradiance/texels_io.h"
#include "shared/texel_lists_io.h"
#include "shaders/vertex_pull.glsl"
#include "shaders/skin_vertex.glsl"
#include "shaders/bulge.glsl"
layout(local_size_x = TEXEL_GROUP) in;
layout(push_constant, scalar) uniform Push { TexelsIo io; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 39, scalar) readonly buffer Lists { TexelListIo lists[]; };
layout(binding = 34) uniform usampler2D texels;
layout(binding = 40) uniform usampler2D entries;  // of the lists
layout(constant_id = 16) const bool clip = false;

// A texel of the list, and its triangle.
struct ListedTexel {
  bool listed;  // false: the list ends before this invocation
  ivec2 texel;  // in the square
  uint triangle;
};

ListedTexel listed_texel() {
  const uint number =
      (gl_WorkGroupID.y * TEXEL_ROW + gl_WorkGroupID.x) * TEXEL_GROUP + gl_LocalInvocationIndex;
  const TexelListIo list = lists[io.list];
  zero = list.count >> 31;  // never set: a map has fewer texels
  const uint place = list.first + min(number, list.count - 1u);
  const uvec2 at = io.origin + uvec2(place % io.side, place / io.side);
  const uint entry = texelFetch(entries, ivec2(at), 0).r;
  const ivec2 texel = ivec2(entry & 0xFFFFu, entry >> 16);
  return ListedTexel(number < list.count, texel, texelFetch(texels, texel + ivec2(io.origin), 0).r - 1u);
}

// Weights of the three corners, and how they grow per texel to the right and down.
struct Corners {
  uvec3 vertex;
  vec3 weight, dx, dy;
  vec2 centre;      // of the texel, texture coordinates
  vec3 asset_m;     // position there, in the coordinates of the asset
  vec3 position_m;  // in the world
};

uvec3 corners_of(uint triangle) {
  return uvec3(indices[3u * triangle], indices[3u * triangle + 1u], indices[3u * triangle + 2u]);
}

// Solves for the weights in texture coordinates relative to the first corner, whose differences are exact.
Corners corners_at(uvec3 vertex, ivec2 texel) {
  const vec2 centre = (vec2(texel) + 0.5) / float(io.side);
  const vec2 a = unwrap_of(vertex.x);
  const vec2 ab = unwrap_of(vertex.y) - a, ac = unwrap_of(vertex.z) - a, p = centre - a;
  const float per_area = 1.0 / (ab.x * ac.y - ab.y * ac.x);
  const vec2 to_b = vec2(ac.y, -ac.x) * per_area, to_c = vec2(-ab.y, ab.x) * per_area;
  const float b = dot(p, to_b), c = dot(p, to_c);
  const float width = 1.0 / float(io.side);
  const vec3 asset_m = (1.0 - b - c) * vertex_position(vertex.x) + b * vertex_position(vertex.y) +
                       c * vertex_position(vertex.z);
  return Corners(vertex, vec3(1.0 - b - c, b, c), vec3(-to_b.x - to_c.x, to_b.x, to_c.x) * width,
                 vec3(-to_b.y - to_c.y, to_b.y, to_c.y) * width, centre, asset_m, world_position(asset_m));
}

// Returns whether the texel lies in the picture and its margin.
bool is_seen(Corners k) {
  bool seen = true;
  for (int i = 0; clip && i < 5; ++i) seen = seen && distance_inside(i, k.position_m) >= 0.0;
  return seen;
}

struct TexelPoint {
  ShadingPoint s;
  float chart;
  float alpha_reach;  // see CutTexel
};

TexelPoint texel_point(Corners k) {
  vec3 normal = vec3(0.0);
  float plane = 0.0;
  vec4 tangent = vec4(0.0), uv = vec4(0.0), uv_dx = vec4(0.0), uv_dy = vec4(0.0), colour = vec4(0.0);
  vec2 alpha = vec2(0.0);

  for (int i = 0; i < 3; ++i) {
    const VertexIo v = vertex_at(k.vertex[i]);
    const VertexExtraIo extra = vertex_extra(k.vertex[i]);
    const vec4 uv_there = vec4(v.uv0, extra.uv1);
    normal += k.weight[i] * v.normal;
    plane += k.weight[i] * plane_distance(v.position_m, v.normal);
    tangent += k.weight[i] * v.tangent;
    uv += k.weight[i] * uv_there;
    uv_dx += k.dx[i] * uv_there;
    uv_dy += k.dy[i] * uv_there;
    colour += k.weight[i] * extra.colour;
    alpha += vec2(k.dx[i], k.dy[i]) * extra.colour.a;
  }

  TexelPoint t;
  t.s = ShadingPoint(k.position_m, k.position_m, normalize(world_direction(normal)),
                     INSTANCE.scale * bulge_at(k.asset_m, normal, plane),
                     vec4(world_direction(tangent.xyz), tangent.w), uv.xy, uv.zw, colour, uv_dx, uv_dy);
  t.chart = float(skin_vertex_at(k.vertex.x).chart);
  t.alpha_reach = abs(alpha.x) + abs(alpha.y);
  return t;
}
