// SPDX-License-Identifier: MIT
// Taps stand in a plane that faces the camera; each weighs by the profile at its distance in space, over the
// density of taps. The sum of the weights divides the light, so that none is lost where taps find no skin of
// this head.
#version 460
#include "passes/disc_gather/disc_gather_io.h"
#include "shaders/half.glsl"
#include "shared/scene_io.h"
layout(constant_id = 0) const int tap_count = 64;
layout(constant_id = 1) const bool burley = false;
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { ScreenIo io; };
layout(binding = 0) uniform sampler2D light;
layout(binding = 1) uniform sampler2D depth_of_skin;
layout(binding = 2) uniform usampler2D surface_of_skin;
#include "shaders/frame.glsl"
layout(binding = 4) uniform sampler2DArray leaving_skin;
layout(binding = 5, scalar) readonly buffer Profiles { DiscProfileIo profiles[]; };
layout(binding = 6, scalar) readonly buffer Taps { DiscTapIo taps[]; };
layout(binding = 7, rgba16f) uniform writeonly image2D target;
#include "passes/screen_surface.glsl"
#include "passes/screen_tangents.glsl"

// Returns R(r), 1/mm^2, but for a factor that is the same at all r; r > 0.
vec3 profile_at(uint mesh, float r2_mm2) {
  if (burley) {
    // [CB15] eq. 3
    const float r_mm = sqrt(r2_mm2);
    const vec3 d = profiles[mesh].distance_mm, e = exp(-r_mm / (3.0 * d));
    return (e * e * e + e) / (d * r_mm);
  }
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < profiles[mesh].terms; ++i)
    sum += profiles[mesh].weight[i] * exp(-r2_mm2 / (2.0 * profiles[mesh].variance_mm2[i]));
  return sum;
}

vec3 gathered(ivec2 at, vec3 middle, uint mesh) {
  const float depth_mm = texelFetch(depth_of_skin, at, 0).r;
  // Half widths and half heights of the picture per mm of the asset there, and pixels.
  const float per_mm =
      1.0 / (frame.camera.orthographic != 0u ? profiles[mesh].mm_per_unit : max(depth_mm, 1e-6));
  const vec2 pixels_per_mm = vec2(io.across, -io.up) * per_mm * 0.5 * vec2(io.extent);
  if (profiles[mesh].reach_mm * abs(pixels_per_mm.y) < 1.0) return middle;

  const uint surface = texelFetch(surface_of_skin, at, 0).x, head = head_of(surface);
  const Tangents t = tangents_at(at, normal_of(surface), depth_mm, profiles[mesh].mm_per_unit);
  const vec2 deeper_per_pixel =
      vec2(dot(frame.camera.direction, t.right_mm), dot(frame.camera.direction, t.down_mm));
  vec3 sum = vec3(0.0), weights = vec3(0.0);
  for (int i = 0; i < tap_count; ++i) {
    const DiscTapIo tap = taps[mesh * uint(tap_count) + uint(i)];
    const vec2 pixels = tap.offset_mm * pixels_per_mm;
    const ivec2 p = at + ivec2(floor(pixels + 0.5));
    if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, ivec2(io.extent)))) continue;
    if (head_of(texelFetch(surface_of_skin, p, 0).x) != head) continue;
    // The point that was meant, not that of the pixel: near the middle many taps share a pixel, and narrow
    // Gaussians would weigh too much on tilted skin if these had no depth.
    const float deeper_mm =
        texelFetch(depth_of_skin, p, 0).r - depth_mm + dot(deeper_per_pixel, pixels - vec2(p - at));
    const float r2_mm2 = dot(tap.offset_mm, tap.offset_mm) + deeper_mm * deeper_mm;
    const vec3 weight = profile_at(mesh, r2_mm2) * tap.per_density_mm2;
    sum += weight * texelFetch(light, p, 0).rgb;
    weights += weight;
  }
  // A channel that no tap reached, or that does not spread, keeps its light.
  return mix(middle, sum / max(weights, vec3(1e-30)), greaterThan(weights, vec3(1e-30)));
}

void main() {
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(gl_GlobalInvocationID.xy, io.extent))) return;
  const vec4 middle = texelFetch(light, at, 0);
  if (middle.a == 0.0) {
    imageStore(target, at, vec4(0.0));
    return;
  }
  const uint mesh = uint(int(texelFetch(leaving_skin, ivec3(at, 0), 0).a) + SURFACE_MESH_MIDDLE);
  imageStore(target, at, vec4(storable(gathered(at, middle.rgb, mesh)), 1.0));
}
