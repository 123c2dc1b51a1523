// SPDX-License-Identifier: MIT
// Light of the environment: uniform, or from a picture (src/environment). Needs `frame`, pi.
layout(constant_id = 7) const bool environment = false;  // a picture; else frame.ambient
layout(binding = 26) uniform sampler2D
    environment_map;  // equirectangular, a lobe twice as wide per mip level: environment/environment.h

// The environment is turned about +Y, so directions are turned back.
vec3 environment_frame(vec3 d) {
  return vec3(d.x * frame.environment_cos - d.z * frame.environment_sin, d.y,
              d.x * frame.environment_sin + d.z * frame.environment_cos);
}

// Returns the place of a direction of the environment, 0..1, v down.
vec2 environment_place(vec3 d) {
  return vec2(0.5 + atan(d.x, -d.z) / (2.0 * pi), acos(clamp(d.y, -1.0, 1.0)) / pi);
}

// Returns the irradiance of an unoccluded surface.
vec3 surroundings_irradiance(vec3 normal) {
  if (!environment) return frame.ambient * pi;
  const vec3 n = environment_frame(normal);
  vec3 e = frame.environment_irradiance[0];
  e += frame.environment_irradiance[1] * n.y + frame.environment_irradiance[2] * n.z +
       frame.environment_irradiance[3] * n.x;
  e += frame.environment_irradiance[4] * (n.x * n.y) + frame.environment_irradiance[5] * (n.y * n.z);
  e += frame.environment_irradiance[6] * (3.0 * n.z * n.z - 1.0) +
       frame.environment_irradiance[7] * (n.x * n.z);
  e += frame.environment_irradiance[8] * (n.x * n.x - n.y * n.y);
  return max(e, vec3(0.0));
}

// Returns the radiance averaged over a Beckmann lobe of slope m around the direction.
vec3 surroundings_radiance(vec3 direction, float m) {
  if (!environment) return frame.ambient;
  const vec3 d = environment_frame(direction);
  const vec2 at = environment_place(d);
  const float level = m < 1.0 / 16.0 ? m * 16.0 : 5.0 + log2(m);
  return textureLod(environment_map, at, level).rgb * frame.environment_intensity;
}

// Returns the part of a lobe of slope m about `towards` that lies in the cone of visible sky: about `sky`, as
// wide as the share `open` of a hemisphere. Two cones, as in [J16] Jimenez, Wu, Pesce, Jarabo: Practical
// Real-Time Strategies for Accurate Indirect Occlusion, SIGGRAPH 2016.
float sky_in_lobe(vec3 sky, float open, vec3 towards, float m) {
  const float cone = asin(sqrt(clamp(open, 0.0, 1.0))), lobe = 1.4 * atan(max(m, 0.01));
  const float between = acos(clamp(dot(sky, towards), -1.0, 1.0));
  return smoothstep(0.0, 1.0, clamp((cone + lobe - between) / (2.0 * lobe), 0.0, 1.0));
}
