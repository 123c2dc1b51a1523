// SPDX-License-Identifier: MIT
// One of the two passes. Taps that do not lie on the surface of the middle take the light of the middle: no
// light is lost, the blur is cut short.
#version 460
#include "render/passes/screen/separable_blur/separable_blur_io.h"
#include "render/shaders/half.glsl"
#include "render/shared/scene_io.h"
layout(constant_id = 0) const int tap_count = 25;
layout(constant_id = 1) const int axis = 0;
layout(constant_id = 2) const bool published = false;
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { ScreenIo io; };
layout(binding = 0) uniform sampler2D light;
layout(binding = 1, r32f) uniform readonly image2D depth_of_skin;
layout(binding = 2) uniform usampler2D surface_of_skin;
#include "render/shaders/frame.glsl"
layout(binding = 4) uniform sampler2DArray leaving_skin;
layout(binding = 5, scalar) readonly buffer Kernels { LineKernelIo kernels[]; };
layout(binding = 6, scalar) readonly buffer Taps { LineTapIo taps[]; };
layout(binding = 7, rgba16f) uniform writeonly image2D target;
#include "render/passes/screen/screen_area.glsl"
#include "render/passes/screen/screen_surface.glsl"
#include "render/passes/screen/screen_tangents.glsl"

// Returns whether no skin of another head is among the four pixels around a point.
bool only_of(uint head, vec2 pixels) {
  const uvec4 around = textureGather(surface_of_skin, pixels / vec2(io.extent)) >> SURFACE_NORMAL_BITS;
  return all(equal(min(around, uvec4(1u)) * head, around));
}

// The authors' rule: a step in texture coordinates, the same along both axes, that knows the distance alone.
vec3 blurred_as_published(ivec2 at, vec3 middle, float depth_mm, uint first, float mm_per_unit) {
  const bool orthographic = frame.camera.orthographic != 0u;
  const float cot = orthographic ? PUBLISHED_COT : io.up;
  const float coordinates = PUBLISHED_WIDTH_MM / 3.0 * (orthographic ? io.up / mm_per_unit : cot / depth_mm);
  const vec2 step =
      axis == 0 ? vec2(coordinates * io.picture_size.x, 0.0) : vec2(0.0, coordinates * io.picture_size.y);
  const float follow =
      PUBLISHED_FOLLOW * cot * PUBLISHED_WIDTH_MM / (PUBLISHED_MM_PER_UNIT * PUBLISHED_MM_PER_UNIT);

  vec3 sum = taps[first].weight * middle;
  for (int i = 1; i < tap_count; ++i) {
    const LineTapIo tap = taps[first + uint(i)];
    const vec2 p = in_area(vec2(at) + 0.5 + tap.offset * step);
    const float there_mm = imageLoad(depth_of_skin, ivec2(p)).r;
    // Where nothing is theirs is far away.
    const float off = there_mm > 0.0 ? clamp(follow * abs(depth_mm - there_mm), 0.0, 1.0) : 1.0;
    sum += tap.weight * mix(skin_light(p, middle), middle, off);
  }
  return sum;
}

// Offsets are mm on the tangent plane. The first pass goes along the rows. The second goes where the plane is
// perpendicular to them, so that a tilted plane has the round kernel of one that faces the camera.
vec3 blurred_on_surface(ivec2 at, vec3 middle, float depth_mm, uint first, LineKernelIo kernel) {
  const uint surface = texelFetch(surface_of_skin, at, 0).x;
  const Tangents t = tangents_at(at, normal_of(surface), depth_mm, kernel.mm_per_unit);
  vec2 step = vec2(1.0 / length(t.right_mm), 0.0);  // pixels per mm
  if (axis == 1) {
    const float along = dot(t.right_mm, t.down_mm) / dot(t.right_mm, t.right_mm);
    step = vec2(-along, 1.0) / length(t.down_mm - along * t.right_mm);
  }

  vec3 sum = taps[first].weight * middle;
  for (int i = 1; i < tap_count; ++i) {
    const LineTapIo tap = taps[first + uint(i)];
    const vec2 p = in_area(vec2(at) + 0.5 + tap.offset * step);
    const ivec2 nearest = ivec2(p);
    const bool same = head_of(texelFetch(surface_of_skin, nearest, 0).x) == head_of(surface);
    const vec3 there =
        only_of(head_of(surface), p) ? skin_light(p, middle) : texelFetch(light, nearest, 0).rgb;
    const float off_mm =
        imageLoad(depth_of_skin, nearest).r - plane_depth_mm(t, depth_mm, vec2(nearest - at));
    // Light does not go where the plane is off by as much as the kernel reaches.
    const float off = same ? clamp(abs(off_mm) * t.cosine / kernel.reach_mm, 0.0, 1.0) : 1.0;
    sum += tap.weight * mix(there, middle, off);
  }
  return sum;
}

void main() {
  if (any(greaterThanEqual(gl_GlobalInvocationID.xy, io.size))) return;
  const ivec2 at = ivec2(io.low + gl_GlobalInvocationID.xy);
  const vec4 middle = texelFetch(light, at, 0);
  if (middle.a == 0.0) {
    imageStore(target, at, vec4(0.0));
    return;
  }

  const uint mesh = uint(int(texelFetch(leaving_skin, ivec3(at, 0), 0).a) + SURFACE_MESH_MIDDLE);
  const LineKernelIo kernel = kernels[mesh];
  const float depth_mm = imageLoad(depth_of_skin, at).r;
  const uint first = mesh * uint(tap_count);
  const vec3 sum = published ? blurred_as_published(at, middle.rgb, depth_mm, first, kernel.mm_per_unit)
                             : blurred_on_surface(at, middle.rgb, depth_mm, first, kernel);
  imageStore(target, at, vec4(storable(sum), 1.0));
}
