// SPDX-License-Identifier: MIT
// Between the four halved pixels around a pixel, of those that show its skin near its tangent plane. A pixel
// with none keeps its light unblurred.
#version 460
#include "passes/restore_skin/restore_skin_io.h"
#include "shaders/half.glsl"
#include "shared/scene_io.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { ScreenIo io; };
layout(binding = 0) uniform sampler2D light;
layout(binding = 1) uniform sampler2D depth_of_skin;
layout(binding = 2) uniform usampler2D surface_of_skin;
#include "shaders/frame.glsl"
layout(binding = 4) uniform sampler2DArray leaving_skin;
layout(binding = 5, scalar) readonly buffer Scales { float mm_per_unit[]; };
layout(binding = 6, rgba16f) uniform readonly image2D blurred;
layout(binding = 7, rgba16f) uniform writeonly image2D target;
layout(binding = 8, r32f) uniform readonly image2D halved_depth;
layout(binding = 9, r32ui) uniform readonly uimage2D halved_surface;
layout(binding = 10) uniform sampler2DArray halved_leaving;
#include "passes/screen_surface.glsl"
#include "passes/screen_tangents.glsl"

void main() {
  if (any(greaterThanEqual(gl_GlobalInvocationID.xy, io.size))) return;
  const ivec2 at = ivec2(io.low + gl_GlobalInvocationID.xy);
  const vec4 middle = texelFetch(light, at, 0);
  if (middle.a == 0.0) {
    imageStore(target, at, vec4(0.0));
    return;
  }

  const float mesh = texelFetch(leaving_skin, ivec3(at, 0), 0).a,
              depth_mm = texelFetch(depth_of_skin, at, 0).r;
  const uint surface = texelFetch(surface_of_skin, at, 0).x;
  const Tangents t =
      tangents_at(at, normal_of(surface), depth_mm, mm_per_unit[uint(int(mesh) + SURFACE_MESH_MIDDLE)]);

  const vec2 between = (vec2(at) + 0.5) * 0.5 - 0.5, corner = floor(between), f = between - corner;
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    const ivec2 d = ivec2(i & 1, i >> 1), p = ivec2(corner) + d;
    if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, imageSize(blurred)))) continue;
    if (head_of(imageLoad(halved_surface, p).x) != head_of(surface) ||
        texelFetch(halved_leaving, ivec3(p, 0), 0).a != mesh)
      continue;
    const vec2 pixels = 2.0 * (vec2(p) + 0.5) - (vec2(at) + 0.5);
    const float off =
        (imageLoad(halved_depth, p).r - plane_depth_mm(t, depth_mm, pixels)) * t.cosine / RESTORE_DEPTH_MM;
    const float weight = (d.x == 1 ? f.x : 1.0 - f.x) * (d.y == 1 ? f.y : 1.0 - f.y) * exp(-0.5 * off * off);
    sum += weight * imageLoad(blurred, p).rgb;
    weights += weight;
  }
  imageStore(target, at, vec4(weights > 1e-3 ? storable(sum / weights) : middle.rgb, 1.0));
}
