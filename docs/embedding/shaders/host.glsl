// SPDX-License-Identifier: MIT
// What the host's shaders know of a frame, and of what they draw.
const float pi = 3.14159265358979;

layout(set = 0, binding = 0) uniform Frame {
  mat4 clip_from_world, shadow_from_world;
  vec4 eye_m;
  vec4 to_lamp;          // of length 1
  vec4 lamp_irradiance;  // on a surface that faces it
};

layout(push_constant) uniform Push {
  mat4 world_from_asset;
  vec4 albedo;  // linear; w: roughness
  uint record;  // HostFrames::record_of()
};
