// SPDX-License-Identifier: MIT
// Passes over the lit tiles of a square find here the triangle of a texel, which
// the map of texels names (render/passes/light_map/texel_map). They find its vertices' values at the centre
// of the texel, too.
// Needs scene_io.h; COMPUTE_SHADING is defined.
#include "render/passes/light_map/irradiance/texels_io.h"
#include "render/shaders/tile_list.glsl"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/skin_vertex.glsl"
#include "render/shaders/bulge.glsl"
layout(local_size_x = TILE_SIDE, local_size_y = TILE_SIDE) in;
layout(push_constant, scalar) uniform Push { TexelsIo io; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 39, scalar) readonly buffer Tiles { uint tiles[]; };
layout(binding = 40, scalar) readonly buffer TileCounts { uint tile_counts[]; };
layout(binding = 34) uniform usampler2D texels;

// A texel of a listed tile, and its triangle.
struct ListedTexel {
  bool listed;  // false: it has none of this material, or the list ends before this workgroup
  ivec2 texel;  // in the square
  uint triangle;
};

ListedTexel listed_texel() {
  const uint count = tile_counts[io.list], number = tile_number(gl_WorkGroupID.xy);
  zero = count >> 31;  // never set: a map has fewer tiles
  const ivec2 texel =
      tile_corner(tiles[io.list * io.room + min(number, count - 1u)]) + ivec2(gl_LocalInvocationID.xy);
  const ivec2 inside = min(texel, ivec2(io.side) - 1);

  const uint triangle = texelFetch(texels, inside + ivec2(io.origin), 0).r - 1u;  // wraps where there is none
  const bool listed =
      number < count && texel == inside && triangle >= io.first_triangle && triangle < io.end_triangle;
  return ListedTexel(listed, inside, listed ? triangle : io.first_triangle);
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
                     WORLD_FROM_ASSET.scale * bulge_at(k.asset_m, normal, plane),
                     vec4(world_direction(tangent.xyz), tangent.w), uv.xy, uv.zw, colour, uv_dx, uv_dy);
  t.chart = float(skin_vertex_at(k.vertex.x).chart);
  t.alpha_reach = abs(alpha.x) + abs(alpha.y);
  return t;
}
