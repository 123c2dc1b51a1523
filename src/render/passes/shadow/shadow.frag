// SPDX-License-Identifier: MIT
// Cut-out parts cast the shadow of what the alpha test leaves.
#version 460
#include "render/shared/scene_io.h"
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
layout(binding = 8) uniform sampler2D map_base_colour;
layout(location = 0) in vec2 in_uv0;
layout(location = 1) in vec2 in_uv1;
layout(location = 2) in vec4 in_colour;
void main() {
  const MapIo map = material.maps[MAP_BASE_COLOUR];
  const vec2 uv = map.uv_set == 0u ? in_uv0 : in_uv1;
  const float alpha = material.base_colour.a * in_colour.a *
                      texture(map_base_colour, map.u_axis * uv.x + map.v_axis * uv.y + map.offset).a;
  if (alpha < material.alpha_cutoff) discard;
}
