// SPDX-License-Identifier: MIT
#version 460
#include "shared/scene_io.h"
#include "passes/labels/labels_io.h"
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
#include "shaders/frame.glsl"
layout(binding = 8) uniform sampler2D map_base_colour;
#include "shaders/cut_out.glsl"
layout(constant_id = 0) const bool skin = false;
layout(push_constant, scalar) uniform Push { LabelsIo io; };
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_uv;
layout(location = 3) in vec4 in_colour;
layout(location = 4) in vec2 in_part;  // how far inside nose and ear
layout(location = 5) in vec4 in_clip;
layout(location = 6) in vec4 in_clip_before;
layout(location = 7) in vec3 in_body;       // unwrap, thickness in mm
layout(location = 0) out vec4 out_surface;  // LabelSurfaceIo
layout(location = 1) out uvec4 out_names;   // LabelNamesIo
layout(location = 2) out vec2 out_motion;   // pixels
layout(location = 3) out vec4 out_body;     // LabelBodyIo

// As ids_cut_out.frag tests skin, and surface.frag all else: from the levels of the map.
bool is_cut_in_picture() {
  if (skin) return is_cut(in_uv, in_colour);
  return material.base_colour.a * in_colour.a * texture(map_base_colour, alpha_uv(in_uv)).a <
         material.alpha_cutoff;
}

uint region() {
  if (!skin) return 0u;
  return in_part.x > 0.0 ? LABEL_REGION_NOSE : in_part.y > 0.0 ? LABEL_REGION_EAR : LABEL_REGION_OTHER_SKIN;
}

// From where the point was in the frame before to where it is, pixels, y down; infinity if it lay behind the
// camera. GPUs interpolate equal values to results that differ in the last bits: so little is no motion.
vec2 motion() {
  if (in_clip_before.w <= 0.0) return vec2(uintBitsToFloat(0x7f800000u));
  precise const vec2 now = in_clip.xy / in_clip.w, then = in_clip_before.xy / in_clip_before.w;
  const float rounding = exp2(-21.0);
  vec2 moved = now - then;
  moved = mix(moved, vec2(0.0), lessThan(abs(moved), vec2(rounding)));
  return moved * vec2(0.5, -0.5) * io.size;  // y of a clip points up
}

void main() {
  if (cut_out && is_cut_in_picture()) discard;

  const float len = length(in_normal);
  const vec3 normal = (gl_FrontFacing ? in_normal : -in_normal) / max(len, 1e-30);
  out_surface = vec4(normal, dot(in_position_m - frame.camera.eye_m, frame.camera.direction));
  out_names = uvec4(io.instance, io.material | region() << LABEL_REGION_SHIFT, floatBitsToUint(in_uv.xy));
  out_motion = motion();
  out_body = vec4(in_body, float(io.skin_mesh));
}
