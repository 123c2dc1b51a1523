// SPDX-License-Identifier: MIT
// Adds what stands behind the heads, by the share of the pixel that no surface covers.
#version 460
#include "render/shared/scene_io.h"
#include "render/passes/pixels/background/background_io.h"
#include "render/shaders/half.glsl"
const float pi = 3.14159265358979;
#include "render/shaders/frame.glsl"
#include "render/shaders/environment.glsl"
layout(constant_id = 0) const uint kind = BEHIND_STUDIO;
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { BackgroundIo io; };
layout(binding = 0) uniform sampler2D picture;
layout(binding = 2) uniform sampler2D open;
layout(binding = 5, rgba16f) uniform writeonly image2D target;

// Middle grey under a lamp one picture height in front of its middle: README.md.
vec3 wall(vec2 heights) {
  const float falloff = 1.0 / (1.0 + dot(heights, heights));
  return vec3(0.18 * falloff * falloff);
}

// Returns the direction in which the camera looks through a point of the picture, -1..1, y up.
vec3 looks_at(vec2 clip) {
  if (frame.camera.orthographic != 0u) return frame.camera.direction;
  const vec4 at = io.world_from_clip * vec4(clip, 0.5, 1.0);
  const vec3 d = normalize(at.xyz / at.w - frame.camera.eye_m);
  return dot(d, frame.camera.direction) < 0.0 ? -d : d;
}

vec3 surroundings(vec2 clip) {
  if (io.has_picture == 0u) return frame.ambient;
  const vec2 at = environment_place(environment_frame(looks_at(clip)));
  return textureLod(environment_map, at, 0.0).rgb * frame.environment_intensity;
}

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy), size = imageSize(target);
  if (any(greaterThanEqual(p, size))) return;

  const vec4 light = texelFetch(picture, p, 0);
  const float share = texelFetch(open, p, 0).r;
  vec3 sum = light.rgb;
  if (share > 0.0) {
    const vec2 middle = vec2(p) + 0.5 - 0.5 * vec2(size);
    if (kind == BEHIND_STUDIO)
      sum += share * frame.radiance_scale * wall(middle / float(size.y));
    else
      sum += share * frame.radiance_scale * surroundings(middle * vec2(2.0, -2.0) / vec2(size));
  }
  imageStore(target, p, vec4(storable(sum), light.a));
}
