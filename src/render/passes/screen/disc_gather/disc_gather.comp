// SPDX-License-Identifier: MIT
// Taps stand in a plane that faces the camera; each weighs by the profile at its distance in space, over the
// density of taps. The sum of the weights divides the light, so that none is lost where taps find no skin of
// this head.
#version 460
#include "render/passes/screen/disc_gather/disc_gather_io.h"
#include "render/shaders/half.glsl"
#include "render/shared/scene_io.h"
layout(constant_id = 0) const int tap_count = 64;
layout(constant_id = 1) const bool burley = false;
layout(constant_id = 2) const bool ue = false;
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { ScreenIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D light;
layout(binding = 1, r32f) uniform readonly image2D depth_of_skin;
layout(binding = 2, r32ui) uniform readonly uimage2D surface_of_skin;
#include "render/shaders/frame.glsl"
layout(binding = 4) uniform sampler2DArray leaving_skin;
layout(binding = 5, scalar) readonly buffer Profiles { DiscProfileIo profiles[]; };
layout(binding = 6, scalar) readonly buffer Taps { DiscTapIo taps[]; };
layout(binding = 8, scalar) readonly buffer Radii { float radii_mm[]; };
layout(binding = 7, rgba16f) uniform writeonly image2D target;
#include "render/passes/screen/screen_surface.glsl"
#include "render/passes/screen/screen_tangents.glsl"

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

// Returns the share of the light of each channel within a radius.
vec3 share_within(uint mesh, float r_mm) {
  vec3 sum = vec3(0.0), all = vec3(0.0);
  for (uint i = 0u; i < profiles[mesh].terms; ++i) {
    const float v = profiles[mesh].variance_mm2[i];
    const vec3 weight = profiles[mesh].weight[i] * v;
    sum += weight * (1.0 - exp(-r_mm * r_mm / (2.0 * v)));
    all += weight;
  }
  return sum / max(all, vec3(1e-30));
}

// Returns a tap of the widest channel's light beyond a share of it.
DiscTapIo tap_beyond(uint mesh, int i, float within) {
  const float share = within + (1.0 - within) * (float(i) + 0.5) / float(tap_count);
  const float at = min(sqrt(-log(1.0 - share)) / DISC_MOST_SHARE, 1.0) * float(DISC_RADII - 1);
  const uint cell = min(uint(at), DISC_RADII - 2u), first = mesh * DISC_RADII + cell;
  const float r = max(mix(radii_mm[first], radii_mm[first + 1u], at - float(cell)), 1e-6);
  const vec2 d = taps[mesh * uint(tap_count) + uint(i)].offset_mm;
  return DiscTapIo(d * (r / max(length(d), 1e-12)),
                   1.0 / max(profile_at(mesh, r * r)[profiles[mesh].widest], 1e-30));
}

vec3 gathered(ivec2 at, vec3 middle, uint mesh) {
  const float depth_mm = imageLoad(depth_of_skin, at).r;
  // Half widths and half heights of the picture per mm of the asset there, and pixels.
  const float per_mm =
      1.0 / (frame.camera.orthographic != 0u ? profiles[mesh].mm_per_unit : max(depth_mm, 1e-6));
  const vec2 pixels_per_mm = vec2(io.across, -io.up) * per_mm * 0.5 * io.picture_size;
  if (profiles[mesh].reach_mm * abs(pixels_per_mm.y) < 1.0) return middle;

  const uint surface = imageLoad(surface_of_skin, at).x, head = head_of(surface);
  const Tangents t = tangents_at(at, normal_of(surface), depth_mm, profiles[mesh].mm_per_unit);
  const vec2 deeper_per_pixel =
      vec2(dot(frame.camera.direction, t.right_mm), dot(frame.camera.direction, t.down_mm));
  const vec3 n = normal_of(surface), within = ue ? share_within(mesh, 1.0 / abs(pixels_per_mm.y)) : vec3(0.0);
  vec3 sum = vec3(0.0), weights = vec3(0.0);
  for (int i = 0; i < tap_count; ++i) {
    DiscTapIo tap = taps[mesh * uint(tap_count) + uint(i)];
    if (ue) tap = tap_beyond(mesh, i, within[profiles[mesh].widest]);
    const vec2 pixels = tap.offset_mm * pixels_per_mm;
    const ivec2 p = at + ivec2(floor(pixels + 0.5));
    if (any(greaterThanEqual(uvec2(p) - io.low, io.size))) continue;
    if (head_of(imageLoad(surface_of_skin, p).x) != head) continue;
    // The point of the tap, not that of the pixel. Near the middle many taps share a pixel, and narrow
    // Gaussians would weigh too much on tilted skin if these had no depth.
    const float deeper_mm =
        imageLoad(depth_of_skin, p).r - depth_mm + dot(deeper_per_pixel, pixels - vec2(p - at));
    const float r2_mm2 = dot(tap.offset_mm, tap.offset_mm) + deeper_mm * deeper_mm;
    vec3 weight = profile_at(mesh, r2_mm2) * tap.per_density_mm2;
    if (ue) {
      const float agree = dot(n, normal_of(imageLoad(surface_of_skin, p).x));
      weight *= sqrt(r2_mm2 / dot(tap.offset_mm, tap.offset_mm) * clamp(0.5 + 0.5 * agree, 0.0, 1.0));
    }
    sum += weight * imageLoad(light, p).rgb;
    weights += weight;
  }
  // A channel that no tap reached, or that does not spread, keeps its light.
  const vec3 around = mix(middle, sum / max(weights, vec3(1e-30)), greaterThan(weights, vec3(1e-30)));
  return ue ? mix(around, middle, within) : around;
}

void main() {
  if (any(greaterThanEqual(gl_GlobalInvocationID.xy, io.size))) return;
  const ivec2 at = ivec2(io.low + gl_GlobalInvocationID.xy);
  const vec4 middle = imageLoad(light, at);
  if (middle.a == 0.0) {
    imageStore(target, at, vec4(0.0));
    return;
  }
  const uint mesh = uint(int(texelFetch(leaving_skin, ivec3(at, 0), 0).a) + SURFACE_MESH_MIDDLE);
  imageStore(target, at, vec4(storable(gathered(at, middle.rgb, mesh)), 1.0));
}
