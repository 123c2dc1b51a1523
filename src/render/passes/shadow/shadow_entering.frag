// SPDX-License-Identifier: MIT
// The part of the light on this texel's surface that enters the skin:
// albedo^mix, stored as its square root, because eight bits then hold dark skin better. Nothing enters other
// surfaces, nor the back of skin. There light first meets the inside of an open mesh, such as a bust or a
// mask, and no body lies behind it. Cut-out parts are skipped. Alpha 1 marks shaded texels; a target of two
// channels has alpha in its second.
#version 460
#include "render/shared/scene_io.h"
#include "render/passes/shadow/shadow_io.h"
#include "render/shaders/switches.glsl"
layout(constant_id = 0) const bool skin = true;
layout(constant_id = 1) const bool cut_out = false;
layout(constant_id = 2) const bool mixed = true;    // mix is not 0
layout(constant_id = 4) const bool facing = false;  // two channels, as where the mix of all skin is 0
layout(push_constant, scalar) uniform Push { ShadowIo io; };
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
#include "render/shaders/frame.glsl"
layout(binding = 8) uniform sampler2D map_base_colour;
layout(location = 0) in vec2 in_uv0;
layout(location = 1) in vec2 in_uv1;
layout(location = 2) in vec4 in_colour;
layout(location = 0) out vec4 out_entering;
void main() {
  const bool enters = skin && gl_FrontFacing == is_on(io.is_turned);
  out_entering = vec4(vec3(enters ? 1.0 : 0.0), 1.0);
  if (facing) out_entering.g = 1.0;
  if (!cut_out && !(skin && mixed)) return;

  const MapIo map = material.maps[MAP_BASE_COLOUR];
  const vec2 uv = map.uv_set == 0u ? in_uv0 : in_uv1;
  vec4 colour = material.base_colour * in_colour;
  if (is_present(map)) colour *= texture(map_base_colour, map.u_axis * uv.x + map.v_axis * uv.y + map.offset);
  if (cut_out && colour.a < material.alpha_cutoff) discard;
  if (enters && mixed && !is_on(frame.white_albedo))
    out_entering.rgb = pow(clamp(colour.rgb, vec3(1e-6), vec3(1.0)), vec3(0.5 * material.mix_before));
}
