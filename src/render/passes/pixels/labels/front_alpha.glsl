// SPDX-License-Identifier: MIT
// Cover of a blended part, as surface.frag has it, without the light that it transmits.
#include "render/shared/scene_io.h"
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
#include "render/shaders/frame.glsl"
layout(binding = 8) uniform sampler2D map_base_colour;
#include "render/shaders/cut_out.glsl"
layout(location = 2) in vec4 in_uv;
layout(location = 3) in vec4 in_colour;

float front_alpha() {
  const float alpha = material.base_colour.a * in_colour.a * texture(map_base_colour, alpha_uv(in_uv)).a;
  return clamp(alpha, 0.0, 1.0);
}
