// SPDX-License-Identifier: MIT
#version 460
// A grey box under the same light as the heads, in the unit of dermis: irradiance pi on white shows 1.
layout(set = 0, binding = 0) uniform sampler2DShadow shadow_map;
layout(set = 0, binding = 1) uniform Light {
  mat4 light_from_world;
  vec4 to_light;  // w: irradiance
  float ambient;
};
layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 position;
layout(location = 0) out vec4 colour;

void main() {
  const vec3 p = (light_from_world * vec4(position, 1.0)).xyz;  // orthographic: w is 1
  const bool inside = all(lessThan(abs(p), vec3(1.0)));         // beyond the map all is lit
  const float lit = inside ? texture(shadow_map, vec3(p.xy * 0.5 + 0.5, p.z - 2e-3)) : 1.0;
  const float cosine = max(dot(normalize(normal), to_light.xyz), 0.0);
  const float grey = 0.4;
  // alpha 0: dermis writes 1 where there is skin
  colour = vec4(vec3(grey * (to_light.w * cosine * lit / 3.14159265 + ambient)), 0.0);
}
